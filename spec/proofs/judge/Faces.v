(* Weights and a linear form that the judge accepts tell the kind of a stationary point: where the form is least on the
   contact set, there is a face of its hull, and the weights put the point in the relative interior of that face. *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint spec.Face
  spec.Stationary spec.StationaryPoint.
From Flowcert Require Import judge.Judge judge.Dimension.
Import ListNotations.
Open Scope R_scope.

(* ---- Weights ---- *)

(* The place c / W, on a grid of the unit s. *)
Definition center_at s W c := vscale (s / IZR W) (emb c).

Lemma positive_combination : forall s W c v F, (0 < W)%Z -> length v = length F -> Forall (fun a => (0 < a)%Z) v ->
  zsum v = W -> zcomb v F = c -> in_relint (map (scaled s) F) (center_at s W c).
Proof.
  intros s W c v F HW HL HP HS HC. assert (WR : 0 < IZR W) by (apply IZR_lt; auto).
  apply positive_weights_sound. exists (map (fun a => IZR a / IZR W) v). repeat split.
  - rewrite !map_length. auto.
  - apply Forall_forall. intros a Ha. apply in_map_iff in Ha. destruct Ha as [b [<- Hb]].
    rewrite Forall_forall in HP. apply Rdiv_lt_0_compat; auto. apply IZR_lt, HP, Hb.
  - rewrite emb_sum, HS by lra. field. lra.
  - unfold scaled. rewrite <- (map_map emb (vscale s)), comb_scaled, emb_comb, HC by lra.
    unfold center_at. apply vec_eq; simpl; field; lra.
Qed.

(* ---- Faces ---- *)

Lemma height_right : forall s W n c p, (0 < W)%Z ->
  dot (emb n) (scaled s p) - dot (emb n) (center_at s W c) = s / IZR W * IZR (height W n c p).
Proof.
  intros s W n c p HW. apply IZR_lt in HW. unfold height, scaled, center_at.
  rewrite minus_IZR, mult_IZR, !emb_dot. unfold dot, vscale; simpl. field. lra.
Qed.

Lemma fitting_weights : forall W n c w C, weights_fit W n c w C = true ->
  (forall p, In p C -> (0 <= height W n c p)%Z) /\
  exists v, length v = length (filter (on_face W n c) C) /\ Forall (fun a => (0 < a)%Z) v /\
    zsum v = zsum w /\ zcomb v (filter (on_face W n c) C) = zcomb w C.
Proof.
  intros W n c. induction w as [|a w IH]; intros [|p C] H; simpl in H; try discriminate.
  - split; [intros p []|]. exists []. simpl. auto.
  - apply andb_true_iff in H. destruct H as [H1 H2]. destruct (IH C H2) as [I1 [v [V1 [V2 [V3 V4]]]]].
    assert (On : on_face W n c p = (height W n c p =? 0)%Z) by reflexivity.
    simpl filter. rewrite On in H1 |- *. clear On. destruct (Z.eqb_spec (height W n c p) 0) as [E|E].
    + apply Z.ltb_lt in H1. split; [intros q [<-|Hq]; [lia | auto]|].
      exists (a :: v). simpl. rewrite V1, V3, V4. auto.
    + rewrite andb_true_iff, Z.ltb_lt, Z.eqb_eq in H1. destruct H1 as [H1 ->].
      split; [intros q [<-|Hq]; [lia | auto]|]. exists v. split; [auto|]. split; [auto|]. split; [simpl; auto|].
      simpl. rewrite V4. destruct (zcomb w C). unfold zadd, zscale; simpl. reflexivity.
Qed.

(* ---- Kinds ---- *)

Lemma kind_right : forall s W n c w C k, 0 < s -> (0 < W)%Z -> zsum w = W -> zcomb w C = c ->
  weights_fit W n c w C = true -> kind_checked W n c C k = true ->
  has_kind (map (scaled s) C) (center_at s W c) k.
Proof.
  intros s W n c w C k Hs HW HS HC Hfit Hk.
  destruct (fitting_weights _ _ _ _ _ Hfit) as [Low [v [V1 [V2 [V3 V4]]]]]. rewrite HS in V3. rewrite HC in V4.
  assert (In_face : in_relint (map (scaled s) (filter (on_face W n c) C)) (center_at s W c))
    by (eapply positive_combination; eauto).
  assert (K0 : 0 < s / IZR W) by (apply Rdiv_lt_0_compat; [auto | apply IZR_lt; auto]).
  (* The plane of spec/Face.v has the other points below it, and that of the form above. *)
  set (u := vscale (-1) (emb n)). set (m := dot u (center_at s W c)).
  assert (Support : forall p, In p C -> dot u (scaled s p) <= m /\
            (on_face W n c p = true <-> dot u (scaled s p) = m)).
  { intros p Hp. assert (E := height_right s W n c p HW). assert (L := Low p Hp). apply IZR_le in L.
    assert (D : m - dot u (scaled s p) = s / IZR W * IZR (height W n c p)).
    { rewrite <- E. unfold m, u. generalize (center_at s W c) (scaled s p) (emb n). clear. intros.
      vdestruct; vunfold; ring. }
    assert (0 <= s / IZR W * IZR (height W n c p)) by (apply Rmult_le_pos; lra).
    split; [lra|]. unfold on_face. rewrite Z.eqb_eq. split.
    - intros Z. rewrite Z in D. lra.
    - intros Z. rewrite Z in D. apply eq_IZR. apply Rmult_eq_reg_l with (s / IZR W); lra. }
  assert (Below : forall p, In p (map (scaled s) C) -> dot u p <= m).
  { intros p Hp. apply in_map_iff in Hp. destruct Hp as [q [<- Hq]]. apply Support; auto. }
  assert (S0 : s <> 0) by lra.
  assert (F : face (map (scaled s) C) (map (scaled s) (filter (on_face W n c) C))).
  { split; [destruct (hull_nonempty _ _ (proj1 In_face)) as [p Hp]; intros E; rewrite E in Hp; destruct Hp|].
    exists u, m. split; [exact Below|]. intros p. rewrite !in_map_iff. split.
    - intros [q [<- Hq]]. apply filter_In in Hq. destruct Hq as [Hq On]. split; [exists q; auto | apply Support; auto].
    - intros [[q [<- Hq]] E]. exists q. split; auto. apply filter_In. split; auto. apply Support; auto. }
  destruct k as [i|i j]; simpl in *; rewrite ?andb_true_iff in Hk.
  - destruct Hk as [H1 H2]. split; [|apply has_dimension_right; auto].
    rewrite forallb_forall in H1. replace (filter (on_face W n c) C) with C in In_face; [auto|].
    symmetry. apply (proj2 (filter_ext_in_iff _ (fun _ => true) C)) in H1. rewrite H1. clear.
    induction C; simpl; congruence.
  - destruct Hk as [[H1 H2] H3]. split; [|split; [|split]].
    + apply (conv_incl (map (scaled s) (filter (on_face W n c) C))); [|apply In_face].
      apply incl_map. intros p Hp. apply filter_In in Hp. apply Hp.
    + intros H. apply negb_true_iff in H1. apply not_true_iff_false in H1. apply H1, forallb_forall. intros p Hp.
      apply Support; auto. apply (touching u m (map (scaled s) C) (center_at s W c)); auto. apply in_map; auto.
    + apply has_dimension_right; auto.
    + exists (map (scaled s) (filter (on_face W n c) C)). split; auto. split; auto. apply has_dimension_right; auto.
Qed.
