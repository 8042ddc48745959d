(* Faces of a convex hull (FC-CRIT-03): each point of the hull is in the relative interior of exactly one of them. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace.
Import ListNotations.
Open Scope R_scope.

(* F has the points of C on a plane that has all others on one side. With u = 0 this is C itself. *)
Definition face_along u m C F :=
  (forall p, In p C -> dot u p <= m) /\ (forall p, In p F <-> In p C /\ dot u p = m).
Definition face C F := F <> [] /\ exists u m, face_along u m C F.

Definition on_plane u m (p : vec) := if Req_EM_T (dot u p) m then true else false.
Lemma on_plane_true : forall u m p, on_plane u m p = true <-> dot u p = m.
Proof. intros. unfold on_plane. destruct (Req_EM_T (dot u p) m); split; congruence. Qed.
Lemma on_plane_right : forall u m C p, In p (filter (on_plane u m) C) <-> In p C /\ dot u p = m.
Proof. intros. rewrite filter_In, on_plane_true. reflexivity. Qed.

(* A point of the hull on a supporting plane is in the hull of the points on it. *)
Lemma comb_on_plane : forall u m C w, length w = length C -> Forall (fun a => 0 <= a) w ->
  (forall p, In p C -> dot u p <= m) -> dot u (comb w C) = m * sum w ->
  exists v, length v = length (filter (on_plane u m) C) /\ Forall (fun a => 0 <= a) v /\ sum v = sum w /\
    comb v (filter (on_plane u m) C) = comb w C.
Proof.
  induction C as [|p C IH]; intros [|a w] L N H E; try discriminate.
  - exists []. auto.
  - rewrite dot_comb_cons in E. inversion N; subst. simpl in E.
    assert (B : dot u (comb w C) <= m * sum w) by (apply comb_below; auto; intros; apply H; right; auto).
    assert (B1 : dot u p <= m) by (apply H; left; auto).
    destruct (IH w) as [v [Lv [Nv [Sv Ev]]]]; auto; [intros; apply H; right; auto | nra |].
    simpl. destruct (on_plane u m p) eqn:Z.
    + exists (a :: v). simpl. rewrite Sv, Ev, Lv. auto.
    + assert (Z' : dot u p <> m) by (intro Z'; apply on_plane_true in Z'; congruence).
      exists v. assert (a = 0) by nra. subst a. rewrite Lv, Sv, Ev. repeat split; auto; [simpl; ring|].
      apply vec_eq; simpl; ring.
Qed.
Lemma conv_on_plane : forall u C x, in_conv C x -> (forall p, In p C -> dot u p <= dot u x) ->
  in_conv (filter (on_plane u (dot u x)) C) x.
Proof.
  intros u C x [w [L [N [S E]]]] H. destruct (comb_on_plane u (dot u x) C w) as [v [Lv [Nv [Sv Ev]]]]; auto.
  - rewrite S, E. ring.
  - exists v. rewrite Sv, Ev. auto.
Qed.

(* A multiple of u that is large enough outweighs u' where u is negative. *)
Lemma outweigh : forall u u' x C, (forall p, In p C -> dot u p <= dot u x) ->
  exists k, 0 <= k /\ forall p, In p C -> dot u p <> dot u x -> dot u' (vsub p x) + k * dot u (vsub p x) < 0.
Proof.
  intros u u' x C H. assert (D : forall a b c, dot a (vsub b c) = dot a b - dot a c).
  { clear. intros; vdestruct; vunfold; ring. }
  induction C as [|q C IH]; [exists 0; split; [lra | intros p []]|].
  destruct IH as [k [Hk B]]; [intros; apply H; right; auto|].
  assert (Hq : dot u q <= dot u x) by (apply H; left; auto).
  destruct (Req_dec (dot u q) (dot u x)) as [E|E].
  - exists k. split; auto. intros p [<-|Hp] N; [contradiction | auto].
  - assert (P : 0 < - dot u (vsub q x)) by (rewrite D; lra).
    set (l := (Rabs (dot u' (vsub q x)) + 1) / - dot u (vsub q x)).
    assert (Hl : 0 < l) by (apply Rdiv_lt_0_compat; [generalize (Rabs_pos (dot u' (vsub q x))); lra | auto]).
    exists (k + l). split; [lra|]. intros p Hp N.
    assert (Np : dot u (vsub p x) < 0).
    { rewrite D. assert (dot u p <= dot u x) by (apply H; auto). lra. }
    destruct Hp as [<-|Hp]; [|generalize (B p Hp N); nra].
    assert (El : l * - dot u (vsub q x) = Rabs (dot u' (vsub q x)) + 1) by (unfold l; field; lra).
    generalize (Rle_abs (dot u' (vsub q x))). nra.
Qed.

Theorem carrying_face : forall C x, in_conv C x -> exists F, face C F /\ in_relint F x.
Proof.
  assert (G : forall n C x, (length C <= n)%nat -> in_conv C x ->
    exists F u, face_along u (dot u x) C F /\ in_relint F x).
  { induction n as [|n IH]; intros C x Hn X.
    - destruct X as [w [L [_ [S _]]]]. destruct C, w; simpl in *; try lia; lra.
    - destruct (supporting_plane C x X) as [R|[u [q [H [Hq Nq]]]]].
      + exists C, vzero. split; auto.
        assert (Z : forall p, dot vzero p = 0) by (intros; vdestruct; vunfold; ring).
        split; intros p; rewrite !Z; [lra | tauto].
      + set (C' := filter (on_plane u (dot u x)) C).
        assert (Shorter : (length C' < length C)%nat).
        { unfold C'. clear - Hq Nq. induction C as [|p C IH]; [destruct Hq|].
          assert (Le : (length (filter (on_plane u (dot u x)) C) <= length C)%nat).
          { clear. induction C as [|p C IH]; simpl; auto. destruct (on_plane u (dot u x) p); simpl; lia. }
          simpl. destruct Hq as [<-|Hq].
          - destruct (on_plane u (dot u x) p) eqn:Z; [apply on_plane_true in Z; contradiction | simpl; lia].
          - specialize (IH Hq). destruct (on_plane u (dot u x) p); simpl; lia. }
        destruct (IH C' x) as [F [u' [[B' A'] R]]]; [lia | apply conv_on_plane; auto |].
        destruct (outweigh u u' x C H) as [k [Hk K]].
        exists F, (vadd u' (vscale k u)). split; auto.
        assert (D : forall p, dot (vadd u' (vscale k u)) p - dot (vadd u' (vscale k u)) x
                              = dot u' (vsub p x) + k * dot u (vsub p x))
          by (clear; intros; vdestruct; vunfold; ring).
        assert (D' : forall p, dot u' (vsub p x) + k * dot u (vsub p x)
                               = dot u' p - dot u' x + k * (dot u p - dot u x))
          by (clear; intros; vdestruct; vunfold; ring).
        assert (On : forall p, In p C' <-> In p C /\ dot u p = dot u x) by (intros; apply on_plane_right).
        split; intros p.
        * intros Hp. apply Rminus_le. rewrite D. destruct (Req_dec (dot u p) (dot u x)) as [E|E].
          -- rewrite D', E. assert (dot u' p <= dot u' x) by (apply B', On; auto). lra.
          -- left. apply K; auto.
        * rewrite A', On. split.
          -- intros [[Hp E] E']. split; auto. apply Rminus_diag_uniq. rewrite D, D', E, E'. ring.
          -- intros [Hp E]. apply Rminus_diag_eq in E. rewrite D in E.
             destruct (Req_dec (dot u p) (dot u x)) as [Eu|Eu]; [|generalize (K p Hp Eu); lra].
             rewrite D', Eu in E. repeat split; auto. lra. }
  intros C x X. destruct (G (length C) C x (le_n _) X) as [F [u [A R]]]. exists F. split; auto.
  split; [|exists u; eauto].
  intros ->. destruct R as [[w [L [_ [S _]]]] _]. destruct w; simpl in *; [lra | discriminate].
Qed.

(* It has the same points as any other. *)
Theorem carrying_face_unique : forall C x F G, face C F -> face C G -> in_relint F x -> in_relint G x ->
  forall p, In p F <-> In p G.
Proof.
  assert (Half : forall C x F G, face C F -> face C G -> in_relint F x -> in_relint G x -> incl F G).
  { intros C x F G [_ [u [m [B A]]]] [_ [v [l [B' A']]]] RF [XG _] p Hp.
    apply A'. apply A in Hp as Hp'. split; [tauto|].
    assert (X : dot v x = l).
    { apply (aff_level v l G); [intros q Hq; apply A' in Hq; tauto | apply conv_in_aff; auto]. }
    apply (touching v l F x); auto. intros q Hq. apply B'. apply A in Hq. tauto. }
  intros C x F G HF HG RF RG p. split; apply (Half C x); auto.
Qed.
