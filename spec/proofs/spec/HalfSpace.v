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

(* A plane that supports the hull at a point of its relative interior contains all of it. *)
Lemma comb_touching : forall u m w C, length w = length C -> Forall (fun a => 0 < a) w ->
  (forall p, In p C -> dot u p <= m) -> dot u (comb w C) = m * sum w -> forall p, In p C -> dot u p = m.
Proof.
  induction w as [|a w IH]; intros [|p C] L N H E q Hq; try discriminate; [destruct Hq|].
  rewrite dot_comb_cons in E. simpl in E. inversion N as [|a' w' Ha Hw]; subst.
  assert (B : dot u (comb w C) <= m * sum w).
  { apply comb_below; auto; [|intros; apply H; right; auto]. eapply Forall_impl; [|exact Hw]. intros; cbv beta in *; lra. }
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

(* Each vector less a multiple of v, so that the product with x is 0. *)
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
