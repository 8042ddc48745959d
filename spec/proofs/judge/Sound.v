(* What the judge accepts is critical, as the specification defines it. *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.CriticalPoint judge.Judge.
Import ListNotations.

Definition emb (p : zvec) : vec := V (IZR (zx p)) (IZR (zy p)) (IZR (zz p)).
Definition position (q : claim) : vec := vscale (/ IZR (denominator q)) (emb (centre q)).

Ltac zunfold := unfold emb, zdet, zdist2, zdot, zcross, zsub, zadd, zscale, det, dist2, dot, cross, vsub, vadd, vscale;
  simpl;
  rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR.

Lemma emb_dot : forall a b, IZR (zdot a b) = dot (emb a) (emb b).
Proof. intros; zunfold; ring. Qed.
Lemma emb_cross : forall a b, emb (zcross a b) = cross (emb a) (emb b).
Proof. intros; zunfold; reflexivity. Qed.
Lemma emb_sub : forall a b, emb (zsub a b) = vsub (emb a) (emb b).
Proof. intros; zunfold; reflexivity. Qed.
Lemma emb_det : forall a b c, IZR (zdet a b c) = det (emb a) (emb b) (emb c).
Proof. intros. unfold zdet, det. rewrite emb_dot, emb_cross. reflexivity. Qed.
Lemma emb_zero : forall a, emb a = vzero <-> znonzero a = false.
Proof.
  intros [x y z]. unfold emb, znonzero, vzero; simpl. rewrite negb_false_iff, !andb_true_iff, !Z.eqb_eq. split.
  - intro H. injection H; intros Hz Hy Hx. repeat split; apply eq_IZR; assumption.
  - intros [[-> ->] ->]. reflexivity.
Qed.

(* ---- pick and scan ---- *)

Lemma pick_spec : forall P i K C, pick P i K = Some C ->
  Forall2 (fun k p => (i <= k)%Z /\ nth_error P (Z.to_nat (k - i)) = Some p) K C.
Proof.
  induction P as [|p P IH]; intros i [|k K] C H; simpl in H.
  - injection H; intro; subst; constructor.
  - discriminate.
  - injection H; intro; subst; constructor.
  - assert (Up : forall k' q, (i + 1 <= k')%Z /\ nth_error P (Z.to_nat (k' - (i + 1))) = Some q ->
                  (i <= k')%Z /\ nth_error (p :: P) (Z.to_nat (k' - i)) = Some q).
    { intros k' q [H1 H2]. split; [lia|].
      replace (Z.to_nat (k' - i)) with (S (Z.to_nat (k' - (i + 1)))) by lia. exact H2. }
    assert (Up2 : forall L D, Forall2 (fun k p => (i + 1 <= k)%Z /\ nth_error P (Z.to_nat (k - (i + 1))) = Some p) L D
      ->
                  Forall2 (fun k q => (i <= k)%Z /\ nth_error (p :: P) (Z.to_nat (k - i)) = Some q) L D).
    { induction 1; constructor; auto. }
    destruct (Z.eqb_spec i k) as [E|E].
    + destruct (pick P (i + 1) K) as [D|] eqn:HD; [|discriminate]. injection H; intro; subst C.
      constructor; [|apply Up2, IH; auto]. subst k. rewrite Z.sub_diag. split; [lia | reflexivity].
    + apply Up2, IH, H.
Qed.

Lemma scan_spec : forall W c r2 P i K, scan W c r2 P i K = true ->
  NoDup K /\ (forall k, In k K -> (i <= k < i + Z.of_nat (length P))%Z) /\
  forall j p, nth_error P j = Some p ->
    (In (i + Z.of_nat j)%Z K /\ zdist2 (zscale W p) c = r2) \/
    (~ In (i + Z.of_nat j)%Z K /\ (r2 < zdist2 (zscale W p) c)%Z).
Proof.
  intros W c r2. induction P as [|p P IH]; intros i K H.
  - destruct K; [|discriminate]. split; [constructor|]. split; [intros k []|].
    intros [|j] q Hj; discriminate.
  - simpl in H.
    destruct K as [|k K].
    + destruct (Z.ltb_spec r2 (zdist2 (zscale W p) c)); [|discriminate].
      destruct (IH _ _ H) as [_ [_ I3]]. split; [constructor|]. split; [intros k []|].
      intros [|j] q Hj; simpl in Hj.
      * injection Hj; intro; subst. right; split; auto.
      * destruct (I3 j q Hj) as [[[] _]|[_ I]]. right; split; auto.
    + destruct (Z.eqb_spec i k) as [E|E].
      * destruct (Z.eqb_spec (zdist2 (zscale W p) c) r2); [|discriminate].
        destruct (IH _ _ H) as [I1 [I2 I3]]. subst k.
        assert (Hi : ~ In i K) by (intro Hin; apply I2 in Hin; lia).
        split; [constructor; auto|]. split.
        { intros k [->|Hk]; [simpl length; lia | apply I2 in Hk; simpl length; lia]. }
        intros [|j] q Hj; simpl in Hj.
        -- injection Hj; intro; subst q. left. split; auto. left. lia.
        -- replace (i + Z.of_nat (S j))%Z with (i + 1 + Z.of_nat j)%Z by lia.
           destruct (I3 j q Hj) as [[I I']|[I I']]; [left | right]; split; auto.
           ++ right; auto.
           ++ intros [Hk|Hk]; [lia | auto].
      * destruct (Z.ltb_spec r2 (zdist2 (zscale W p) c)); [|discriminate].
        destruct (IH _ _ H) as [I1 [I2 I3]].
        split; auto. split.
        { intros k' Hk. apply I2 in Hk. simpl length. lia. }
        intros [|j] q Hj; simpl in Hj.
        -- injection Hj; intro; subst q. right. split; auto. intro Hin. apply I2 in Hin. lia.
        -- replace (i + Z.of_nat (S j))%Z with (i + 1 + Z.of_nat j)%Z by lia. apply I3; auto.
Qed.

(* ---- Dimension ---- *)

Open Scope R_scope.

Lemma find_some_or_none : forall (f : zvec -> bool) l,
  (exists d, find f l = Some d /\ In d l /\ f d = true) \/ (find f l = None /\ forall d, In d l -> f d = false).
Proof.
  intros f l. destruct (find f l) as [d|] eqn:E.
  - left. exists d. apply find_some in E. tauto.
  - right. split; auto. apply find_none, E.
Qed.

Lemma independent_1 : forall d, d <> vzero -> independent [d].
Proof.
  intros d Hd [|a [|? ?]] L H; try discriminate. constructor; [|constructor].
  destruct (Req_dec a 0) as [|Ha]; auto. exfalso. apply Hd.
  simpl in H. destruct d; unfold vadd, vscale, vzero in H; simpl in H; injection H; intros.
  apply vec_eq; simpl; apply Rmult_eq_reg_l with a; auto; lra.
Qed.
Lemma span_1 : forall d v, d <> vzero -> cross d v = vzero -> in_span [d] v.
Proof.
  intros d v Hd Hc.
  assert (Hdd : dot d d <> 0) by (intro H; apply Hd, dot_self_zero, H).
  exists [dot d v / dot d d]. split; auto. simpl.
  assert (E : vscale (dot d v) d = vscale (dot d d) v).
  { assert (F : vsub (vscale (dot d v) d) (vscale (dot d d) v) = cross d (cross d v)).
    { clear; apply vec_eq; vdestruct; vunfold; ring. }
    rewrite Hc in F. revert F. clear. intro F.
    assert (G : cross d vzero = vzero) by (apply vec_eq; vunfold; ring). rewrite G in F.
    destruct (vscale (dot d v) d), (vscale (dot d d) v). unfold vsub, vzero in F; simpl in F; injection F; intros.
    apply vec_eq; simpl; lra. }
  assert (E' : vscale (/ dot d d) (vscale (dot d v) d) = v).
  { rewrite E. apply vec_eq; simpl; field; auto. }
  rewrite <- E' at 2. apply vec_eq; simpl; field; auto.
Qed.

Lemma independent_2 : forall a b, cross a b <> vzero -> independent [a; b].
Proof.
  intros a b H [|s [|t [|? ?]]] L E; try discriminate. simpl in E.
  assert (Hn : dot (cross a b) (cross a b) <> 0) by (intro Hz; apply H, dot_self_zero, Hz).
  assert (Es : cross (vadd (vscale s a) (vadd (vscale t b) vzero)) b = vscale s (cross a b))
    by (apply vec_eq; clear; vdestruct; vunfold; ring).
  assert (Et : cross a (vadd (vscale s a) (vadd (vscale t b) vzero)) = vscale t (cross a b))
    by (apply vec_eq; clear; vdestruct; vunfold; ring).
  rewrite E in Es, Et.
  assert (Z1 : cross vzero b = vzero) by (apply vec_eq; vunfold; ring).
  assert (Z2 : cross a vzero = vzero) by (apply vec_eq; vunfold; ring).
  rewrite Z1 in Es. rewrite Z2 in Et.
  assert (K : forall k, vzero = vscale k (cross a b) -> k = 0).
  { intros k Hk. apply Rmult_eq_reg_r with (dot (cross a b) (cross a b)); auto.
    replace (k * dot (cross a b) (cross a b)) with (dot (vscale k (cross a b)) (cross a b))
      by (unfold dot, vscale; simpl; ring).
    rewrite <- Hk. unfold dot, vzero; simpl. ring. }
  repeat constructor; apply K; auto.
Qed.
Lemma span_2 : forall a b v, cross a b <> vzero -> det v a b = 0 -> in_span [a; b] v.
Proof.
  intros a b v H Hd.
  assert (Hn : dot (cross a b) (cross a b) <> 0) by (intro Hz; apply H, dot_self_zero, Hz).
  set (n := cross a b) in *. set (k := dot n n) in *.
  exists [dot (cross v b) n / k; dot (cross a v) n / k]. split; auto. simpl.
  assert (F : vadd (vscale (dot (cross v b) n) a) (vscale (dot (cross a v) n) b)
              = vsub (vscale k v) (vscale (det v a b) n)).
  { unfold k, n. clear. apply vec_eq; vdestruct; vunfold; ring. }
  rewrite Hd in F.
  assert (F' : vscale (/ k) (vadd (vscale (dot (cross v b) n) a) (vscale (dot (cross a v) n) b)) = v).
  { rewrite F. apply vec_eq; simpl; field; auto. }
  rewrite <- F' at 3. apply vec_eq; simpl; field; auto.
Qed.

Lemma independent_3 : forall c a b, det c a b <> 0 -> independent [c; a; b].
Proof.
  intros c a b H [|r [|s [|t [|? ?]]]] L E; try discriminate. simpl in E.
  set (v := vadd (vscale r c) (vadd (vscale s a) (vadd (vscale t b) vzero))) in *.
  assert (Er : det v a b = r * det c a b) by (unfold v; clear; vdestruct; vunfold; ring).
  assert (Es : det c v b = s * det c a b) by (unfold v; clear; vdestruct; vunfold; ring).
  assert (Et : det c a v = t * det c a b) by (unfold v; clear; vdestruct; vunfold; ring).
  rewrite E in Er, Es, Et.
  assert (det vzero a b = 0 /\ det c vzero b = 0 /\ det c a vzero = 0)
    by (clear; vdestruct; vunfold; repeat split; ring).
  repeat constructor; apply Rmult_eq_reg_r with (det c a b); auto; lra.
Qed.
Lemma span_3 : forall c a b v, det c a b <> 0 -> in_span [c; a; b] v.
Proof.
  intros c a b v H.
  exists [det v a b / det c a b; det c v b / det c a b; det c a v / det c a b]. split; auto. simpl.
  assert (F : vadd (vscale (det v a b) c) (vadd (vscale (det c v b) a) (vscale (det c a v) b)) = vscale (det c a b) v).
  { clear; apply vec_eq; vdestruct; vunfold; ring. }
  assert (F' : vscale (/ det c a b)
    (vadd (vscale (det v a b) c) (vadd (vscale (det c v b) a) (vscale (det c a v) b))) = v).
  { rewrite F. apply vec_eq; simpl; field; auto. }
  rewrite <- F' at 4. apply vec_eq; simpl; field; auto.
Qed.

Lemma zrank_spec : forall p0 rest,
  affine_dimension (map emb (p0 :: rest)) (zrank (map (fun p => zsub p p0) (p0 :: rest))).
Proof.
  intros p0 rest. set (C := p0 :: rest). set (ds := map (fun p => zsub p p0) C).
  assert (In0 : In (emb p0) (map emb C)) by (left; reflexivity).
  assert (Hds : forall d, In d ds -> exists p, In p (map emb C) /\ emb d = vsub p (emb p0)).
  { intros d Hd. unfold ds in Hd. apply in_map_iff in Hd. destruct Hd as [p [<- Hp]].
    exists (emb p). split; [apply in_map; auto | apply emb_sub]. }
  assert (All : forall (Q : vec -> Prop), (forall d, In d ds -> Q (emb d)) ->
                forall p, In p (map emb C) -> Q (vsub p (emb p0))).
  { intros Q HQ p Hp. apply in_map_iff in Hp. destruct Hp as [z [<- Hz]].
    rewrite <- emb_sub. apply HQ. unfold ds. apply (in_map (fun p => zsub p p0)); auto. }
  assert (NZ : forall d, znonzero d = true -> emb d <> vzero).
  { intros d Hd E. apply emb_zero in E. congruence. }
  unfold zrank.
  destruct (find_some_or_none znonzero ds) as [[d1 [-> [I1 N1]]]|[-> Z1]].
  2: { exists (emb p0), []. split; [exact In0|]. split; [reflexivity|]. split; [|split].
       - intros [|? ?] L _; [constructor | discriminate].
       - intros b [].
       - apply (All (in_span [])). intros d Hd. apply Z1, emb_zero in Hd. rewrite Hd. exists []; auto. }
  apply NZ in N1.
  destruct (find_some_or_none (fun d => znonzero (zcross d1 d)) ds) as [[d2 [-> [I2 N2]]]|[-> Z2]].
  2: { exists (emb p0), [emb d1]. split; [exact In0|]. split; [reflexivity|]. split; [|split].
       - apply independent_1; auto.
       - intros b [<-|[]]; auto.
       - apply (All (in_span [emb d1])). intros d Hd. apply span_1; auto.
         rewrite <- emb_cross. apply emb_zero. apply (Z2 d Hd). }
  apply NZ in N2. rewrite emb_cross in N2.
  destruct (find_some_or_none (fun d => negb (zdet d d1 d2 =? 0)%Z) ds) as [[d3 [-> [I3 N3]]]|[-> Z3]].
  - apply negb_true_iff, Z.eqb_neq in N3.
    assert (N3' : det (emb d3) (emb d1) (emb d2) <> 0).
    { rewrite <- emb_det. intro E. apply eq_IZR in E. auto. }
    exists (emb p0), [emb d3; emb d1; emb d2]. split; [exact In0|]. split; [reflexivity|]. split; [|split].
    + apply independent_3; auto.
    + intros b [<-|[<-|[<-|[]]]]; auto.
    + intros p _. apply span_3; auto.
  - exists (emb p0), [emb d1; emb d2]. split; [exact In0|]. split; [reflexivity|]. split; [|split].
    + apply independent_2; auto.
    + intros b [<-|[<-|[]]]; auto.
    + apply (All (in_span [emb d1; emb d2])). intros d Hd. apply span_2; auto.
      specialize (Z3 d Hd). apply negb_false_iff, Z.eqb_eq in Z3. rewrite <- emb_det, Z3. reflexivity.
Qed.

(* ---- Weights ---- *)

Lemma emb_comb : forall k w C, k <> 0 ->
  comb (map (fun a => IZR a / k) w) (map emb C) = vscale (/ k) (emb (zcomb w C)).
Proof.
  intros k. induction w as [|a w IH]; intros [|p C] Hk; simpl; try (apply vec_eq; simpl; ring).
  rewrite IH by auto. unfold zadd, zscale, emb; simpl.
  apply vec_eq; simpl; rewrite plus_IZR, mult_IZR; field; auto.
Qed.
Lemma emb_sum : forall k w, k <> 0 -> sum (map (fun a => IZR a / k) w) = IZR (zsum w) / k.
Proof.
  intros k w Hk. induction w as [|a w IH]; simpl; [field; auto|]. rewrite IH, plus_IZR. field; auto.
Qed.
Lemma zsum_pos : forall w, w <> [] -> forallb (Z.ltb 0) w = true -> (0 < zsum w)%Z.
Proof.
  assert (G : forall w, forallb (Z.ltb 0) w = true -> (0 <= zsum w)%Z).
  { induction w; simpl; [lia|]. rewrite andb_true_iff, Z.ltb_lt. intros [H1 H2]. apply IHw in H2. lia. }
  intros [|a w] H F; [congruence|]. simpl in *. rewrite andb_true_iff, Z.ltb_lt in F. destruct F as [F1 F2].
  apply G in F2. lia.
Qed.

Lemma nth_error_emb : forall P j p, nth_error (map emb P) j = Some p ->
  exists z, nth_error P j = Some z /\ p = emb z.
Proof.
  induction P as [|a P IH]; intros [|j] p H; simpl in *; try discriminate.
  - injection H; intro; subst. exists a; auto.
  - apply IH; auto.
Qed.

Theorem judge_sound : forall P q, check P q = true ->
  critical (map emb P) (position q) (ids q) (index q).
Proof.
  intros P q H. unfold check in H.
  destruct (pick P 0 (ids q)) as [[|p0 rest]|] eqn:HP; try discriminate.
  set (C := p0 :: rest) in *. set (W := zsum (weights q)) in *. set (c := zcomb (weights q) C) in *.
  rewrite !andb_true_iff, !Z.eqb_eq, Z.ltb_lt in H.
  destruct H as [[[[[[[HL HW] Hden] Hx] Hy] Hz] Hk] Hs].
  apply Nat.eqb_eq in HL. apply Nat.eqb_eq in Hk.
  assert (W0 : (0 < W)%Z).
  { apply zsum_pos; auto. intro E. rewrite E in HL. discriminate. }
  assert (WR : 0 < IZR W) by (apply IZR_lt; auto).
  assert (DR : 0 < IZR (denominator q)) by (apply IZR_lt; auto).
  (* the claimed position is the combination of the weights *)
  assert (Pos : position q = vscale (/ IZR W) (emb c)).
  { apply (f_equal IZR) in Hx, Hy, Hz. rewrite !mult_IZR in Hx, Hy, Hz. unfold position.
    assert (K : forall u v, IZR W * u = IZR (denominator q) * v -> / IZR (denominator q) * u = / IZR W * v).
    { intros u v E. apply Rmult_eq_reg_l with (IZR W * IZR (denominator q)); [|nra].
      replace (IZR W * IZR (denominator q) * (/ IZR (denominator q) * u)) with (IZR W * u) by (field; lra).
      replace (IZR W * IZR (denominator q) * (/ IZR W * v)) with (IZR (denominator q) * v) by (field; lra). exact E. }
    apply vec_eq; simpl; apply K; auto. }
  assert (Dist : forall p, dist2 (position q) (emb p) = IZR (zdist2 (zscale W p) c) * (/ IZR W * / IZR W)).
  { intros p. rewrite Pos. unfold zdist2. rewrite emb_dot, emb_sub.
    assert (E : vsub (vscale (/ IZR W) (emb c)) (emb p) = vscale (- / IZR W) (vsub (emb (zscale W p)) (emb c))).
    { unfold emb, zscale. apply vec_eq; simpl; rewrite mult_IZR; field; lra. }
    unfold dist2. rewrite E. unfold dot, vscale; simpl. ring. }
  assert (IW : 0 < / IZR W * / IZR W) by (apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; auto).
  destruct (scan_spec _ _ _ _ _ _ Hs) as [S1 [S2 S3]].
  set (r2 := zdist2 (zscale W p0) c) in *.
  assert (HC : Forall2 (point_at (map emb P)) (ids q) (map emb C)).
  { generalize (pick_spec _ _ _ _ HP). clear. induction 1 as [|k p K D [H1 H2] HK IH]; simpl; constructor; auto.
    split; auto. rewrite Z.sub_0_r in H2. apply map_nth_error; auto. }
  (* every point is at least as far as r2, the contacts exactly *)
  assert (Far : forall p, In p (map emb P) -> IZR r2 * (/ IZR W * / IZR W) <= dist2 (position q) p).
  { intros p Hp. apply in_map_iff in Hp. destruct Hp as [z [<- Hz']]. rewrite Dist.
    apply In_nth_error in Hz'. destruct Hz' as [j Hj]. apply Rmult_le_compat_r; [lra|]. apply IZR_le.
    destruct (S3 j z Hj) as [[_ E]|[_ E]]; lia. }
  split.
  - split; auto. intros i. split.
    + intros Hi. destruct (S2 i Hi) as [B1 B2].
      assert (Hj : (Z.to_nat i < length P)%nat) by lia.
      destruct (nth_error P (Z.to_nat i)) as [p|] eqn:Ep; [|apply nth_error_None in Ep; lia].
      exists (emb p). split; [split; [lia | apply map_nth_error; auto]|].
      intros x Hx'. destruct (S3 _ _ Ep) as [[_ E]|[N _]].
      * rewrite Dist, E. apply Far; auto.
      * exfalso. apply N. replace (0 + Z.of_nat (Z.to_nat i))%Z with i by lia. auto.
    + intros [p [[B1 Ep] Near]]. apply nth_error_emb in Ep. destruct Ep as [z [Ez ->]].
      destruct (S3 _ _ Ez) as [[E _]|[_ E]].
      * replace (0 + Z.of_nat (Z.to_nat i))%Z with i in E by lia. auto.
      * exfalso. (* p0 is nearer *)
        assert (In0 : In (emb p0) (map emb P)).
        { inversion HC as [|k x K D [_ Hn] _ EK ED]. apply nth_error_In in Hn. exact Hn. }
        generalize (Near _ In0). rewrite !Dist. fold r2. apply IZR_lt in E. nra.
  - exists (map emb C). split; auto. split.
    + apply positive_weights_sound. exists (map (fun a => IZR a / IZR W) (weights q)). repeat split.
      * rewrite !map_length. auto.
      * rewrite forallb_forall in HW. apply Forall_forall. intros x Hx'. apply in_map_iff in Hx'.
        destruct Hx' as [a [<- Ha]]. apply HW, Z.ltb_lt, IZR_lt in Ha. apply Rdiv_lt_0_compat; auto.
      * rewrite emb_sum by lra. fold W. field. lra.
      * rewrite emb_comb by lra. fold c. auto.
    + rewrite <- Hk. apply zrank_spec.
Qed.
Print Assumptions judge_sound.
