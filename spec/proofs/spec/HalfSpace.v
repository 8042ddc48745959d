(* Linear functions on hulls: a bound that holds at all points of a list holds in their hull.
   Farkas' lemma: a vector is a sum of given ones with weights that are not negative, or a plane parts it from them.
   So a point of a hull is in the relative interior, or a plane supports the hull there. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull.
Import ListNotations.
Open Scope R_scope.

Lemma dot_comb_cons : forall u a w p C, dot u (comb (a :: w) (p :: C)) = a * dot u p + dot u (comb w C).
Proof. intros. simpl. generalize (comb w C). intros. vdestruct; vunfold; ring. Qed.
Lemma dot_vzero : forall u, dot u vzero = 0.
Proof. intros. vdestruct; vunfold; ring. Qed.

Lemma comb_below : forall u m w C, length w = length C -> Forall (fun a => 0 <= a) w ->
  (forall p, In p C -> dot u p <= m) -> dot u (comb w C) <= m * sum w.
Proof.
  induction w as [|a w IH]; intros [|p C] L N H; try discriminate.
  - simpl. rewrite dot_vzero. lra.
  - rewrite dot_comb_cons. inversion N; subst. simpl sum.
    assert (dot u (comb w C) <= m * sum w) by (apply IH; auto; intros; apply H; right; auto).
    assert (dot u p <= m) by (apply H; left; auto). nra.
Qed.
Lemma comb_level : forall u m w C, length w = length C -> (forall p, In p C -> dot u p = m) ->
  dot u (comb w C) = m * sum w.
Proof.
  induction w as [|a w IH]; intros [|p C] L H; try discriminate.
  - simpl. rewrite dot_vzero. lra.
  - rewrite dot_comb_cons, IH, H; [simpl; ring | left; auto | auto | intros; apply H; right; auto].
Qed.
Lemma conv_below : forall u m C x, (forall p, In p C -> dot u p <= m) -> in_conv C x -> dot u x <= m.
Proof. intros u m C x H [w [L [N [S <-]]]]. generalize (comb_below u m w C L N H). rewrite S. lra. Qed.
Lemma aff_level : forall u m C x, (forall p, In p C -> dot u p = m) -> in_aff C x -> dot u x = m.
Proof. intros u m C x H [w [L [S <-]]]. rewrite (comb_level u m) by auto. rewrite S. ring. Qed.
Lemma conv_in_aff : forall C x, in_conv C x -> in_aff C x.
Proof. intros C x [w [L [_ [S E]]]]. exists w. auto. Qed.

(* A hull depends on the points alone, and not on their order or on how often they are in the list. *)
Lemma unit_weights : forall D p, In p D ->
  exists e, length e = length D /\ Forall (fun a => 0 <= a) e /\ sum e = 1 /\ comb e D = p.
Proof.
  induction D as [|d D IH]; intros p H; [destruct H|]. destruct H as [<-|H].
  - exists (1 :: repeat 0 (length D)). simpl. rewrite repeat_length, sum_repeat. repeat split; auto.
    + constructor; [lra | apply Forall_repeat; lra].
    + ring.
    + assert (E : forall n (l : list vec), comb (repeat 0 n) l = vzero).
      { induction n as [|n In]; intros [|q l]; simpl; auto. rewrite In. apply vec_eq; simpl; ring. }
      rewrite E. apply vec_eq; simpl; ring.
  - destruct (IH p H) as [e [L [N [S E]]]]. exists (0 :: e). simpl. rewrite E, S. repeat split; auto; try lra.
    + constructor; auto. lra.
    + apply vec_eq; simpl; ring.
Qed.
Lemma nonneg_ladd : forall u v, length u = length v -> Forall (fun a => 0 <= a) u -> Forall (fun a => 0 <= a) v ->
  Forall (fun a => 0 <= a) (ladd u v).
Proof.
  induction u as [|a u IH]; intros [|b v] L Hu Hv; simpl; constructor; inversion Hu; inversion Hv; subst; try lra.
  apply IH; auto.
Qed.
Lemma nonneg_lscale : forall k u, 0 <= k -> Forall (fun a => 0 <= a) u -> Forall (fun a => 0 <= a) (lscale k u).
Proof.
  intros k u Hk H. unfold lscale. rewrite Forall_map. eapply Forall_impl; [|exact H].
  intros a Ha. cbv beta in *. apply Rmult_le_pos; auto.
Qed.
Lemma weights_over : forall C D, incl C D -> forall w, length w = length C ->
  exists v, length v = length D /\ sum v = sum w /\ comb v D = comb w C /\
    (Forall (fun a => 0 <= a) w -> Forall (fun a => 0 <= a) v).
Proof.
  induction C as [|p C IH]; intros D H [|a w] L; try discriminate.
  - exists (repeat 0 (length D)). simpl. rewrite repeat_length, sum_repeat. repeat split; auto; [ring | |].
    + clear H. induction D as [|d D ID]; simpl; auto. rewrite ID. apply vec_eq; simpl; ring.
    + intros _. apply Forall_repeat. lra.
  - injection L; intro L'. destruct (IH D (fun q Hq => H q (or_intror Hq)) w L') as [v [Lv [Sv [Ev Nv]]]].
    destruct (unit_weights D p (H p (or_introl eq_refl))) as [e [Le [Ne [Se Ee]]]].
    assert (Ls : length (lscale a e) = length D) by (rewrite lscale_length; auto).
    exists (ladd (lscale a e) v). repeat split.
    + apply ladd_length; auto.
    + rewrite sum_ladd, sum_lscale, Se, Sv by congruence. simpl. ring.
    + rewrite comb_ladd, comb_lscale, Ee, Ev by auto. reflexivity.
    + intros N. inversion N; subst. apply nonneg_ladd; [congruence | apply nonneg_lscale; auto | auto].
Qed.
Lemma conv_incl : forall C D x, incl C D -> in_conv C x -> in_conv D x.
Proof.
  intros C D x H [w [L [N [S E]]]]. destruct (weights_over C D H w L) as [v [Lv [Sv [Ev Nv]]]].
  exists v. rewrite Sv, Ev. auto.
Qed.
Lemma conv_between : forall C c y a, in_conv C c -> in_conv C y -> 0 <= a <= 1 ->
  in_conv C (vadd c (vscale a (vsub y c))).
Proof.
  intros C c y a [w [L [N [S E]]]] [v [L' [N' [S' E']]]] A.
  exists (ladd (lscale (1 - a) w) (lscale a v)). repeat split.
  - apply ladd_length; rewrite lscale_length; auto.
  - apply nonneg_ladd; [rewrite !lscale_length; congruence | |]; apply nonneg_lscale; auto; lra.
  - rewrite sum_ladd, !sum_lscale, S, S' by (rewrite !lscale_length; congruence). ring.
  - rewrite comb_ladd, !comb_lscale, E, E' by (rewrite ?lscale_length; auto). apply vec_eq; simpl; ring.
Qed.
Lemma point_in_conv : forall C p, In p C -> in_conv C p.
Proof. intros C p H. destruct (unit_weights C p H) as [e He]. exists e. tauto. Qed.
Lemma aff_incl : forall C D x, incl C D -> in_aff C x -> in_aff D x.
Proof.
  intros C D x H [w [L [S E]]]. destruct (weights_over C D H w L) as [v [Lv [Sv [Ev _]]]].
  exists v. rewrite Sv, Ev. auto.
Qed.
Lemma relint_same : forall C D x, incl C D -> incl D C -> in_relint C x -> in_relint D x.
Proof.
  intros C D x H H' [X [r [Hr B]]]. split; [apply (conv_incl C); auto|]. exists r. split; auto.
  intros y Hy Hd. apply (conv_incl C); auto. apply B; auto. apply (aff_incl D); auto.
Qed.

(* A plane that supports the hull at a point of its relative interior contains all of it. *)
Lemma comb_touching : forall u m w C, length w = length C -> Forall (fun a => 0 < a) w ->
  (forall p, In p C -> dot u p <= m) -> dot u (comb w C) = m * sum w -> forall p, In p C -> dot u p = m.
Proof.
  induction w as [|a w IH]; intros [|p C] L N H E q Hq; try discriminate; [destruct Hq|].
  rewrite dot_comb_cons in E. simpl in E. inversion N as [|a' w' Ha Hw]; subst.
  assert (B : dot u (comb w C) <= m * sum w).
  { apply comb_below; auto; [|intros; apply H; right; auto].
    eapply Forall_impl; [|exact Hw]. intros; cbv beta in *; lra. }
  assert (B1 : dot u p <= m) by (apply H; left; auto).
  assert (E1 : dot u p = m) by nra.
  destruct Hq as [<-|Hq]; [exact E1|]. apply (IH C); auto; [intros; apply H; right; auto | nra].
Qed.
Lemma touching : forall u m C x, in_relint C x -> (forall p, In p C -> dot u p <= m) -> dot u x = m ->
  forall p, In p C -> dot u p = m.
Proof.
  intros u m C x R H E. apply positive_weights_complete in R. destruct R as [w [L [N [S <-]]]].
  apply (comb_touching u m w); auto. rewrite S. lra.
Qed.

(* ---- Farkas' lemma ---- *)

Definition in_cone V b := exists w, length w = length V /\ Forall (fun a => 0 <= a) w /\ comb w V = b.
Definition parts u V b := Forall (fun v => dot u v <= 0) V /\ 0 < dot u b.

(* A multiple of v is taken from b, so that the product with x is 0. *)
Definition less v x b := vsub b (vscale (dot x b / dot x v) v).

Lemma comb_less : forall v x w V, length w = length V ->
  comb w (map (less v x) V) = vsub (comb w V) (vscale (dot x (comb w V) / dot x v) v).
Proof.
  induction w as [|a w IH]; intros [|p V] L; try discriminate.
  - simpl. rewrite dot_vzero. unfold Rdiv. apply vec_eq; simpl; ring.
  - rewrite dot_comb_cons. simpl. rewrite IH by auto. unfold less, Rdiv. generalize (comb w V). intros q.
    apply vec_eq; simpl; ring.
Qed.

Theorem farkas : forall V b, in_cone V b \/ exists u, parts u V b.
Proof.
  intros V. remember (length V) as n eqn:Hn. revert V Hn.
  induction n as [|n IH]; intros [|v V] Hn b; try discriminate.
  - destruct (Req_dec (dot b b) 0) as [E|E].
    + left. exists []. apply dot_self_zero in E. subst b. auto.
    + right. exists b. split; [constructor|]. generalize (dot_self_nonneg b); lra.
  - injection Hn; intro Hn'. destruct (IH V Hn' b) as [[w [L [N E]]]|[x [Hx Hb]]].
    + left. exists (0 :: w). repeat split; [simpl; auto | constructor; auto; lra |]. simpl. rewrite E.
      apply vec_eq; simpl; ring.
    + destruct (Rle_dec (dot x v) 0) as [Hv|Hv]; [right; exists x; split; auto|].
      assert (P : 0 < dot x v) by lra.
      destruct (IH (map (less v x) V) ltac:(rewrite map_length; auto) (less v x b)) as [[w [L [N E]]]|[y [Hy Yb]]].
      * left. rewrite map_length in L. rewrite comb_less in E by auto.
        assert (K : dot x (comb w V) <= 0).
        { replace 0 with (0 * sum w) by ring. apply comb_below; auto. rewrite Forall_forall in Hx. exact Hx. }
        exists ((dot x b - dot x (comb w V)) / dot x v :: w). repeat split; [simpl; auto | |].
        -- constructor; auto. apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, P].
        -- unfold less in E. apply (f_equal (fun a => vadd a (vscale (dot x b / dot x v) v))) in E.
           simpl. revert E. generalize (comb w V). intros q E.
           transitivity (vadd (vsub q (vscale (dot x q / dot x v) v)) (vscale (dot x b / dot x v) v)).
           ++ apply vec_eq; simpl; unfold Rdiv; ring.
           ++ rewrite E. apply vec_eq; simpl; ring.
      * right. exists (vsub y (vscale (dot y v / dot x v) x)).
        assert (F : forall p, dot (vsub y (vscale (dot y v / dot x v) x)) p = dot y (less v x p)).
        { intros. unfold less, Rdiv. generalize (/ dot x v). intros k. clear. vdestruct; vunfold; ring. }
        split; [|rewrite F; auto]. constructor.
        -- rewrite F. unfold less. replace (vsub v (vscale (dot x v / dot x v) v)) with vzero.
           ++ rewrite dot_vzero. lra.
           ++ apply vec_eq; simpl; field; lra.
        -- apply Forall_forall. intros p Hp. rewrite F. rewrite Forall_map, Forall_forall in Hy. apply Hy, Hp.
Qed.

(* ---- Supporting planes ---- *)

Lemma level_or_off : forall u m C, (forall p, In p C -> dot u p = m) \/ exists p, In p C /\ dot u p <> m.
Proof.
  induction C as [|p C IH]; [left; intros q []|].
  destruct (Req_dec (dot u p) m) as [E|E]; [|right; exists p; split; [left; auto | auto]].
  destruct IH as [IH|[q [Hq N]]]; [left; intros q [<-|Hq]; auto | right; exists q; split; [right; auto | auto]].
Qed.

(* Where a point of the hull is not in the relative interior, a plane through it has points on one side, and none on
   the other. *)
Theorem supporting_plane : forall C x, in_conv C x ->
  in_relint C x \/ exists u q, (forall p, In p C -> dot u p <= dot u x) /\ In q C /\ dot u q <> dot u x.
Proof.
  intros C x X. set (V := map (fun p => vsub p x) C).
  destruct (farkas V (comb (repeat (-1) (length C)) V)) as [[w [L [N E]]]|[u [U S]]].
  - left. apply positive_weights_sound. unfold V in L. rewrite map_length in L.
    set (v := ladd w (repeat 1 (length C))).
    assert (Lr : forall a : R, length (repeat a (length C)) = length C) by (intros; apply repeat_length).
    assert (Lv : length v = length C) by (apply ladd_length; auto).
    assert (Nv : Forall (fun a => 1 <= a) v).
    { unfold v. rewrite <- L. clear - N. induction N; simpl; constructor; auto. lra. }
    assert (Sv : 0 < sum v).
    { assert (Nn : Forall (fun a => 0 <= a) v) by (eapply Forall_impl; [|exact Nv]; intros; cbv beta in *; lra).
      destruct C as [|p C]; [destruct X as [w' [Lw [_ [Sw _]]]]; destruct w'; simpl in *; [lra | discriminate]|].
      destruct v as [|a v']; [discriminate|]. inversion Nv; subst. inversion Nn; subst. simpl.
      assert (G : forall l, Forall (fun a => 0 <= a) l -> 0 <= sum l) by (induction 1; simpl; lra).
      generalize (G v' H4); lra. }
    assert (Z : comb v V = vzero).
    { unfold v. rewrite comb_ladd, E by (unfold V; rewrite map_length; auto).
      rewrite <- comb_ladd by (unfold V; rewrite map_length; auto). clearbody V. clear.
      generalize (length C). intros n. revert V. induction n; intros [|q V]; simpl; auto.
      rewrite IHn. apply vec_eq; simpl; ring. }
    exists (lscale (/ sum v) v). rewrite lscale_length, sum_lscale, comb_lscale. repeat split; auto.
    + unfold lscale. rewrite Forall_map. eapply Forall_impl; [|exact Nv]. intros a Ha. cbv beta in *.
      apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat; auto | lra].
    + field. lra.
    + unfold V in Z. rewrite comb_shift in Z by auto.
      transitivity (vadd (vscale (/ sum v) (vsub (comb v C) (vscale (sum v) x))) x).
      * apply vec_eq; simpl; field; lra.
      * rewrite Z. apply vec_eq; simpl; ring.
  - right.
    assert (B : forall p, In p C -> dot u p <= dot u x).
    { intros p Hp. rewrite Forall_forall in U. specialize (U (vsub p x) (in_map (fun q => vsub q x) C p Hp)).
      revert U. clear. vdestruct; vunfold. lra. }
    destruct (level_or_off u (dot u x) C) as [A|[q [Hq Nq]]]; [|exists u, q; auto].
    exfalso. rewrite (comb_level u 0) in S.
    + lra.
    + unfold V. rewrite repeat_length, map_length. auto.
    + intros v Hv. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]]. generalize (A p Hp). clear. intro.
      vdestruct; vunfold. lra.
Qed.
