(* What the judge does with rows: the grid holds each of them exactly, pick finds the points that ids name, and scan
   tells the rows at the least distance, of which it names the first of equal ones. *)
From Coq Require Import Reals ZArith Lra Lia List Bool Sorted.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.StationaryPoint judge.Judge judge.Dimension.
Import ListNotations.

(* ---- The grid ---- *)

Definition unit_of g := powerRZ 2 g.
Lemma unit_positive : forall g, (0 < unit_of g)%R.
Proof. intros. apply powerRZ_lt. lra. Qed.
Lemma unit_add : forall a b, unit_of (a + b) = (unit_of a * unit_of b)%R.
Proof. intros. apply powerRZ_add. lra. Qed.
Lemma unit_integer : forall e, (0 <= e)%Z -> IZR (2 ^ e) = unit_of e.
Proof.
  intros e He. unfold unit_of. rewrite <- (Z2Nat.id e) by auto. rewrite <- pow_powerRZ.
  induction (Z.to_nat e) as [|n IH]; [reflexivity|]. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia.
  rewrite mult_IZR, IH. reflexivity.
Qed.

Definition reaches g d := mantissa d = 0%Z \/ exists e, g = Some e /\ (e <= exponent d)%Z.
Definition no_more a b := forall e, a = Some e -> exists f, b = Some f /\ (f <= e)%Z.

Lemma no_more_trans : forall a b c, no_more a b -> no_more b c -> no_more a c.
Proof.
  intros a b c H1 H2 e He. destruct (H1 e He) as [f [Hf L]]. destruct (H2 f Hf) as [h [Hh L']].
  exists h. split; auto. lia.
Qed.
Lemma reaches_no_more : forall a b d, reaches a d -> no_more a b -> reaches b d.
Proof.
  intros a b d [H|[e [He L]]] N; [left; auto|]. right. destruct (N e He) as [f [Hf L']]. exists f. split; auto. lia.
Qed.
Lemma least_right : forall g d, no_more g (least g d) /\ reaches (least g d) d.
Proof.
  intros g d. unfold least, no_more, reaches. destruct (Z.eqb_spec (mantissa d) 0).
  - split; [|auto]. intros f ->. exists f. split; [auto | lia].
  - destruct g as [e|]; split.
    + intros f E. injection E; intro; subst. exists (Z.min f (exponent d)). split; [auto | lia].
    + right. exists (Z.min e (exponent d)). split; [auto | lia].
    + intros e E. discriminate.
    + right. exists (exponent d). split; [auto | lia].
Qed.
Lemma least_of_row_right : forall g r, no_more g (least_of_row g r) /\ reaches (least_of_row g r) (row_x r) /\
  reaches (least_of_row g r) (row_y r) /\ reaches (least_of_row g r) (row_z r).
Proof.
  intros g r. unfold least_of_row.
  destruct (least_right g (row_x r)) as [X1 X2]. set (a := least g (row_x r)) in *.
  destruct (least_right a (row_y r)) as [Y1 Y2]. set (b := least a (row_y r)) in *.
  destruct (least_right b (row_z r)) as [Z1 Z2]. set (c := least b (row_z r)) in *.
  assert (N : no_more a c) by (eapply no_more_trans; eauto).
  split; [eapply no_more_trans; eauto|]. split; [eapply reaches_no_more; eauto|].
  split; [eapply reaches_no_more; eauto | auto].
Qed.
Lemma fold_least : forall rows g, no_more g (fold_left least_of_row rows g) /\
  forall r, In r rows -> reaches (fold_left least_of_row rows g) (row_x r) /\
    reaches (fold_left least_of_row rows g) (row_y r) /\ reaches (fold_left least_of_row rows g) (row_z r).
Proof.
  induction rows as [|a rows IH]; intros g; simpl.
  - split; [intros e ->; exists e; split; [auto | lia] | intros r []].
  - destruct (IH (least_of_row g a)) as [I1 I2]. destruct (least_of_row_right g a) as [A1 [A2 [A3 A4]]].
    split; [eapply no_more_trans; eauto|]. intros r [<-|Hr]; auto.
    split; [|split]; eapply reaches_no_more; eauto.
Qed.

Lemma on_grid_right : forall g d, (mantissa d = 0%Z \/ (g <= exponent d)%Z) ->
  value d = (unit_of g * IZR (on_grid g d))%R.
Proof.
  intros g d H. unfold value, on_grid. fold (unit_of (exponent d)). destruct (Z.eqb_spec (mantissa d) 0) as [E|E].
  - rewrite E. ring.
  - destruct H as [H|H]; [contradiction|]. rewrite mult_IZR, unit_integer by lia.
    replace (exponent d) with (g + (exponent d - g))%Z at 1 by lia. rewrite unit_add. ring.
Qed.

Definition grid_point g r := at_grid (place_of g r).
Lemma row_on_grid : forall rows r, In r rows ->
  row_point r = scaled (unit_of (grid_of rows)) (grid_point (grid_of rows) r).
Proof.
  intros rows r Hr. destruct (fold_least rows None) as [_ F]. destruct (F r Hr) as [X [Y Z]].
  assert (G : forall d, reaches (fold_left least_of_row rows None) d ->
                mantissa d = 0%Z \/ (grid_of rows <= exponent d)%Z).
  { intros d [H|[e [He L]]]; [auto|]. right. unfold grid_of. rewrite He. auto. }
  unfold row_point, scaled, emb, grid_point, place_of; simpl.
  apply vec_eq; simpl; apply on_grid_right; auto.
Qed.

Lemma prepared_places : forall rows, places (prepare rows) = map (place_of (grid_of rows)) rows.
Proof.
  intros rows. unfold prepare; simpl. rewrite rev_append_rev, app_nil_r.
  assert (G : forall l done, fold_left (fun done r => place_of (grid_of rows) r :: done) l done =
                rev (map (place_of (grid_of rows)) l) ++ done).
  { induction l as [|a l IH]; intros done; simpl; [reflexivity|]. rewrite IH, <- app_assoc. reflexivity. }
  rewrite G, app_nil_r. apply rev_involutive.
Qed.

(* ---- Ids and places ---- *)

Open Scope Z_scope.

Lemma pick_spec : forall P i K C, pick P i K = Some C ->
  Forall2 (fun k c => i <= k /\ exists p, nth_error P (Z.to_nat (k - i)) = Some p /\ at_grid p = c) K C.
Proof.
  induction P as [|p P IH]; intros i [|k K] C H; simpl in H.
  - injection H; intro; subst; constructor.
  - discriminate.
  - injection H; intro; subst; constructor.
  - assert (Up : forall L D,
      Forall2 (fun k c => i + 1 <= k /\ exists q, nth_error P (Z.to_nat (k - (i + 1))) = Some q /\ at_grid q = c) L D ->
      Forall2 (fun k c => i <= k /\ exists q, nth_error (p :: P) (Z.to_nat (k - i)) = Some q /\ at_grid q = c) L D).
    { induction 1 as [|l c L D [H1 H2] _ IHL]; constructor; auto. split; [lia|].
      replace (Z.to_nat (l - i)) with (S (Z.to_nat (l - (i + 1)))) by lia. exact H2. }
    destruct (Z.eqb_spec i k) as [E|E].
    + destruct (pick P (i + 1) K) as [D|] eqn:HD; [|discriminate]. injection H; intro; subst C.
      constructor; [|apply Up, IH; auto]. subst k. rewrite Z.sub_diag. split; [lia | exists p; auto].
    + apply Up, IH, H.
Qed.

Lemma zsame_eq : forall a b, zsame a b = true <-> a = b.
Proof.
  intros [a1 a2 a3] [b1 b2 b3]. unfold zsame; simpl. rewrite !andb_true_iff, !Z.eqb_eq. split.
  - intros [[-> ->] ->]. reflexivity.
  - intro H. injection H; auto.
Qed.
Lemma existsb_zsame : forall p l, existsb (zsame p) l = true <-> In p l.
Proof.
  intros p l. rewrite existsb_exists. split.
  - intros [q [Hq E]]. apply zsame_eq in E. subst. auto.
  - intros H. exists p. split; auto. apply zsame_eq. auto.
Qed.

(* Before the place j there is one of K with the point q, or one was seen before all of P. *)
Definition earlier P i K (seen : list zvec) j q :=
  In q seen \/ exists j' p, (j' < j)%nat /\ nth_error P j' = Some p /\ In (i + Z.of_nat j') K /\ at_grid p = q.

Lemma earlier_later : forall P p i K seen j q, ~ In i K ->
  (earlier P (i + 1) K seen j q <-> earlier (p :: P) i K seen (S j) q).
Proof.
  intros P p i K seen j q Hi. unfold earlier. split; (intros [H|[j' [p' [H1 [H2 [H3 H4]]]]]]; [left; auto|]).
  - right. exists (S j'), p'. split; [lia|]. split; auto. split; auto.
    replace (i + Z.of_nat (S j')) with (i + 1 + Z.of_nat j') by lia. auto.
  - destruct j' as [|j'].
    + exfalso. apply Hi. replace i with (i + Z.of_nat 0) by lia. auto.
    + right. exists j', p'. split; [lia|]. split; auto. split; auto.
      replace (i + 1 + Z.of_nat j') with (i + Z.of_nat (S j')) by lia. auto.
Qed.
Lemma earlier_first : forall P p i K seen j q, ~ In i K ->
  (earlier P (i + 1) K (at_grid p :: seen) j q <-> earlier (p :: P) i (i :: K) seen (S j) q).
Proof.
  intros P p i K seen j q Hi. unfold earlier. split.
  - intros [[H|H]|[j' [p' [H1 [H2 [H3 H4]]]]]]; [right | left; auto | right].
    + exists 0%nat, p. split; [lia|]. split; auto. split; auto. left. lia.
    + exists (S j'), p'. split; [lia|]. split; auto. split; auto. right.
      replace (i + Z.of_nat (S j')) with (i + 1 + Z.of_nat j') by lia. auto.
  - intros [H|[j' [p' [H1 [H2 [H3 H4]]]]]]; [left; right; auto|]. destruct j' as [|j'].
    + left. left. injection H2; intro; subst; auto.
    + right. exists j', p'. split; [lia|]. split; auto. split; auto.
      replace (i + 1 + Z.of_nat j') with (i + Z.of_nat (S j')) by lia. destruct H3 as [H3|H3]; [lia | auto].
Qed.
Lemma earlier_0 : forall P i K seen q, earlier P i K seen 0 q <-> In q seen.
Proof. intros. unfold earlier. split; [intros [H|[j [p [H _]]]]; [auto | lia] | auto]. Qed.

(* ---- Scanning ---- *)

Definition place_right W c r P i K seen j p :=
  In (i + Z.of_nat j) K /\ nearness W c p = r /\ ~ earlier P i K seen j (at_grid p) \/
  ~ In (i + Z.of_nat j) K /\ (r < nearness W c p \/ nearness W c p = r /\ earlier P i K seen j (at_grid p)).

Lemma scan_spec : forall W c r P i K seen, scan W c r P i K seen = true ->
  StronglySorted Z.lt K /\ (forall k, In k K -> i <= k < i + Z.of_nat (length P)) /\
  forall j p, nth_error P j = Some p -> place_right W c r P i K seen j p.
Proof.
  intros W c r. induction P as [|p P IH]; intros i K seen H.
  - destruct K; [|discriminate]. split; [constructor|]. split; [intros k []|]. intros [|j] q Hj; discriminate.
  - assert (Later : ~ In i K -> scan W c r P (i + 1) K seen = true ->
      (r < nearness W c p \/ nearness W c p = r /\ In (at_grid p) seen) ->
      StronglySorted Z.lt K /\ (forall k, In k K -> i <= k < i + Z.of_nat (length (p :: P))) /\
      forall j q, nth_error (p :: P) j = Some q -> place_right W c r (p :: P) i K seen j q).
    { intros Hi HS HP. destruct (IH _ _ _ HS) as [I1 [I2 I3]]. split; auto. split.
      { intros k Hk. apply I2 in Hk. simpl length. lia. }
      intros [|j] q Hj; unfold place_right; simpl in Hj.
      - injection Hj; intro; subst q. right. rewrite earlier_0, Z.add_0_r. auto.
      - rewrite <- earlier_later by auto. replace (i + Z.of_nat (S j)) with (i + 1 + Z.of_nat j) by lia.
        apply (I3 j q Hj). }
    assert (Over : forall S, scan W c r P (i + 1) K S = true -> ~ In i K).
    { intros S HS Hin. destruct (IH _ _ _ HS) as [_ [I2 _]]. apply I2 in Hin. lia. }
    simpl in H. destruct K as [|k K].
    + destruct (Z.ltb_spec r (nearness W c p)); [eapply Later; eauto|].
      destruct ((nearness W c p =? r) && existsb (zsame (at_grid p)) seen) eqn:E; [|discriminate].
      rewrite andb_true_iff, Z.eqb_eq, existsb_zsame in E. eapply Later; eauto.
    + destruct (Z.eqb_spec i k) as [E|E].
      * destruct ((nearness W c p =? r) && negb (existsb (zsame (at_grid p)) seen)) eqn:F; [|discriminate].
        rewrite andb_true_iff, Z.eqb_eq, negb_true_iff, <- not_true_iff_false, existsb_zsame in F.
        destruct F as [F1 F2]. destruct (IH _ _ _ H) as [I1 [I2 I3]]. simpl in I1, I2, I3. subst k.
        assert (Hi : ~ In i K) by (intro Hin; apply I2 in Hin; lia).
        split. { constructor; auto. apply Forall_forall. intros k Hk. apply I2 in Hk. lia. }
        split. { intros k [->|Hk]; [simpl length; lia | apply I2 in Hk; simpl length; lia]. }
        intros [|j] q Hj; unfold place_right; simpl in Hj.
        -- injection Hj; intro; subst q. left. rewrite earlier_0. split; [left; lia | auto].
        -- rewrite <- earlier_first by auto. replace (i + Z.of_nat (S j)) with (i + 1 + Z.of_nat j) by lia.
           destruct (I3 j q Hj) as [[J1 J2]|[J1 J2]]; [left | right]; split; auto.
           ++ right; auto.
           ++ intros [Hk|Hk]; [lia | auto].
      * destruct (Z.ltb_spec r (nearness W c p)); [eapply Later; eauto|].
        destruct ((nearness W c p =? r) && existsb (zsame (at_grid p)) seen) eqn:F; [|discriminate].
        rewrite andb_true_iff, Z.eqb_eq, existsb_zsame in F. eapply Later; eauto.
Qed.
