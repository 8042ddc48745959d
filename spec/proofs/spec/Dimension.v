(* The affine dimension of a finite list of points (CriticalPoint.v): there is exactly one, and it is at most 3.
   It does not fall where points are added, and grows where one is added outside of the affine hull. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint.
Import ListNotations.
Open Scope R_scope.

(* ---- Spans ---- *)

Lemma span_of : forall D d, In d D -> in_span D d.
Proof. intros D d H. destruct (unit_weights D d H) as [e [L [_ [_ E]]]]. exists e. auto. Qed.
Lemma span_sub : forall S a b, in_span S a -> in_span S b -> in_span S (vsub a b).
Proof.
  intros S a b Ha Hb. replace (vsub a b) with (vsub a (vscale 1 b)) by (apply vec_eq; simpl; ring).
  apply span_sub_scale; auto.
Qed.
Lemma span_trans : forall S D, (forall d, In d D -> in_span S d) -> forall v, in_span D v -> in_span S v.
Proof.
  intros S D H v [c [L <-]]. revert c L. induction D as [|d D IH]; intros [|a c] L; try discriminate.
  - exists (repeat 0 (length S)). split; [apply repeat_length|]. simpl. clear.
    induction S as [|s S IS]; simpl; auto. rewrite IS. apply vec_eq; simpl; ring.
  - simpl. replace (vadd (vscale a d) (comb c D)) with (vsub (comb c D) (vscale (- a) d))
      by (apply vec_eq; simpl; ring).
    apply span_sub_scale; [apply IH; [intros; apply H; right; auto | auto] | apply H; left; auto].
Qed.

Lemma comb_app : forall c1 c2 B1 B2, length c1 = length B1 ->
  comb (c1 ++ c2) (B1 ++ B2) = vadd (comb c1 B1) (comb c2 B2).
Proof.
  induction c1 as [|a c1 IH]; intros c2 [|b B1] B2 L; try discriminate; simpl.
  - apply vec_eq; simpl; ring.
  - rewrite IH by auto. apply vec_eq; simpl; ring.
Qed.

(* ---- Independent vectors are at most as many as those that span them ---- *)

(* A vector is given as k s + v, with v in the span of the others. *)
Definition joined s (l : R * vec) := vadd (vscale (fst l) s) (snd l).

Lemma split_joined : forall s S B, (forall b, In b B -> in_span (s :: S) b) ->
  exists L, B = map (joined s) L /\ forall l, In l L -> in_span S (snd l).
Proof.
  induction B as [|b B IH]; intros H.
  - exists []. split; [auto | intros l []].
  - destruct IH as [L [E HL]]; [intros; apply H; right; auto|].
    destruct (H b (or_introl eq_refl)) as [[|k c] [Lc Ec]]; [discriminate|].
    exists ((k, comb c S) :: L). split.
    + simpl. rewrite <- E, <- Ec. reflexivity.
    + intros l [<-|Hl]; [|auto]. exists c. auto.
Qed.
Lemma split_nonzero : forall L : list (R * vec),
  (forall l, In l L -> fst l = 0) \/ exists L1 l L2, L = L1 ++ l :: L2 /\ fst l <> 0.
Proof.
  induction L as [|l L IH]; [left; intros l []|].
  destruct (Req_dec (fst l) 0) as [E|E]; [|right; exists [], l, L; auto].
  destruct IH as [IH|[L1 [l' [L2 [EL E']]]]].
  - left. intros l' [<-|H]; auto.
  - right. exists (l :: L1), l', L2. rewrite EL. auto.
Qed.

(* A multiple of l0 is taken from l, so that nothing is left along s. *)
Definition without (l0 l : R * vec) := vsub (snd l) (vscale (fst l / fst l0) (snd l0)).
Fixpoint steps (c : list R) (L : list (R * vec)) :=
  match c, L with a :: c', l :: L' => a * fst l + steps c' L' | _, _ => 0 end.

Lemma comb_without : forall s l0 c L, fst l0 <> 0 -> length c = length L ->
  comb c (map (without l0) L) = vsub (comb c (map (joined s) L)) (vscale (steps c L / fst l0) (joined s l0)).
Proof.
  induction c as [|a c IH]; intros [|l L] H0 E; try discriminate; simpl.
  - apply vec_eq; simpl; field; exact H0.
  - rewrite IH by auto. unfold without, joined. apply vec_eq; simpl; field; exact H0.
Qed.

Theorem independent_length : forall S B, (forall b, In b B -> in_span S b) -> independent B ->
  (length B <= length S)%nat.
Proof.
  induction S as [|s S IH]; intros B H I.
  - destruct B as [|b B]; [auto|]. exfalso.
    assert (Z : forall p, In p (b :: B) -> p = vzero).
    { intros p Hp. destruct (H p Hp) as [[|k c] [L E]]; [|discriminate]. simpl in E. auto. }
    assert (F : Forall (fun a => a = 0) (1 :: repeat 0 (length B))).
    { apply I; [simpl; rewrite repeat_length; auto|].
      rewrite (Z b) by (left; auto). simpl. replace (comb (repeat 0 (length B)) B) with vzero.
      - apply vec_eq; simpl; ring.
      - symmetry. clear. induction B as [|q B IB]; simpl; auto. rewrite IB. apply vec_eq; simpl; ring. }
    inversion F. lra.
  - destruct (split_joined s S B H) as [L [-> HL]]. rewrite map_length.
    destruct (split_nonzero L) as [Z|[L1 [l0 [L2 [-> N]]]]].
    + assert (E : map (joined s) L = map snd L).
      { apply map_ext_in. intros l Hl. unfold joined. rewrite Z by auto. apply vec_eq; simpl; ring. }
      rewrite E in *. simpl. apply Nat.le_trans with (length S); [|lia].
      rewrite <- (map_length snd L). apply IH; auto.
      intros b Hb. apply in_map_iff in Hb. destruct Hb as [l [<- Hl]]. auto.
    + rewrite app_length. simpl. apply Nat.le_trans with (Datatypes.S (length (L1 ++ L2))); [rewrite app_length; lia|].
      simpl. apply le_n_S. rewrite <- (map_length (without l0)). apply IH.
      * intros b Hb. apply in_map_iff in Hb. destruct Hb as [l [<- Hl]]. unfold without. apply span_sub_scale.
        -- apply HL. apply in_or_app. apply in_app_or in Hl. destruct Hl; [left | right; right]; auto.
        -- apply HL. apply in_or_app. right. left. auto.
      * intros c Lc Ec. rewrite map_length in Lc. rewrite (comb_without s) in Ec by auto.
        assert (Split : exists c1 c2, c = c1 ++ c2 /\ length c1 = length L1 /\ length c2 = length L2).
        { rewrite app_length in Lc. exists (firstn (length L1) c), (skipn (length L1) c).
          rewrite firstn_skipn, firstn_length, skipn_length. repeat split; lia. }
        destruct Split as [c1 [c2 [-> [Lc1 Lc2]]]].
        set (k := - (steps (c1 ++ c2) (L1 ++ L2) / fst l0)) in *.
        assert (F : Forall (fun a => a = 0) (c1 ++ k :: c2)).
        { apply I.
          - rewrite map_length, !app_length. simpl. lia.
          - rewrite map_app, comb_app by (rewrite map_length; auto). rewrite map_app, comb_app in Ec
              by (rewrite map_length; auto).
            rewrite <- Ec. simpl. unfold k. apply vec_eq; simpl; ring. }
        apply Forall_app in F. destruct F as [F1 F2]. inversion F2; subst. apply Forall_app. auto.
Qed.

(* ---- A basis ---- *)

(* A vector that is not in the span goes with independent ones. *)
Lemma span_or_apart : forall B d, in_span B d \/
  exists r, (forall b, in_span B b -> dot r b = 0) /\ dot r d <> 0.
Proof.
  intros B d. destruct (span_bound B) as [_ P]. destruct (P d) as [s [Hs O]].
  destruct (Req_dec (dot (vsub d s) (vsub d s)) 0) as [Z|Z].
  - left. apply dot_self_zero in Z. replace d with s; auto.
    transitivity (vsub d (vsub d s)); [apply vec_eq; simpl; ring|]. rewrite Z. apply vec_eq; simpl; ring.
  - right. exists (vsub d s). split; auto.
    intro E. apply Z. transitivity (dot (vsub d s) d - dot (vsub d s) s); [clear; vdestruct; vunfold; ring|].
    rewrite E, (O s Hs). ring.
Qed.
Lemma independent_cons : forall B r d, (forall b, In b B -> dot r b = 0) -> dot r d <> 0 -> independent B ->
  independent (d :: B).
Proof.
  intros B r d O N I [|k c] L E; [discriminate|]. injection L; intro L'.
  assert (K : k = 0).
  { apply (f_equal (dot r)) in E. rewrite dot_comb_cons, dot_vzero in E.
    rewrite (comb_level r 0) in E by auto.
    assert (E' : k * dot r d = 0) by lra. apply Rmult_integral in E'. tauto. }
  subst k. constructor; auto. apply I; auto. rewrite <- E. simpl. apply vec_eq; simpl; ring.
Qed.
Lemma basis : forall D, exists B, incl B D /\ independent B /\ forall d, In d D -> in_span B d.
Proof.
  induction D as [|d D [B [S [I G]]]].
  - exists []. split; [intros x []|]. split; [intros [|a c] L _; [constructor | discriminate] | intros d []].
  - destruct (span_or_apart B d) as [H|[r [O N]]].
    + exists B. split; [intros b Hb; right; auto|]. split; auto. intros q [<-|Hq]; auto.
    + exists (d :: B). split; [intros b [<-|Hb]; [left | right]; auto|]. split.
      * apply (independent_cons B r); auto.
      * assert (Up : forall q, in_span B q -> in_span (d :: B) q).
        { apply span_trans. intros b Hb. apply span_of. right. auto. }
        intros q [<-|Hq]; [apply span_of; left; auto | auto].
Qed.

(* ---- The dimension ---- *)

Theorem affine_dimension_exists : forall C p, In p C -> exists k, affine_dimension C k.
Proof.
  intros C p Hp. destruct (basis (map (fun q => vsub q p) C)) as [B [S [I G]]].
  exists (length B), p, B. split; [auto|]. split; [auto|]. split; [auto|]. split.
  - intros b Hb. apply S, in_map_iff in Hb. destruct Hb as [q [E Hq]]. exists q. auto.
  - intros q Hq. apply G, in_map_iff. exists q. auto.
Qed.

Lemma basis_spans : forall D p0 B b, In p0 D -> (forall p, In p D -> in_span B (vsub p p0)) ->
  forall p q, In p D -> In q D -> b = vsub p q -> in_span B b.
Proof.
  intros D p0 B b H0 H p q Hp Hq ->.
  replace (vsub p q) with (vsub (vsub p p0) (vsub q p0)) by (apply vec_eq; simpl; ring). apply span_sub; auto.
Qed.

Theorem affine_dimension_incl : forall C D k m, incl C D -> affine_dimension C k -> affine_dimension D m ->
  (k <= m)%nat.
Proof.
  intros C D k m H [p0 [B [H0 [L [I [S _]]]]]] [q0 [B' [H0' [L' [_ [_ G]]]]]]. subst k m.
  apply independent_length; auto. intros b Hb. destruct (S b Hb) as [p [Hp E]].
  apply (basis_spans D q0 B' b H0' G p p0); auto.
Qed.
Corollary affine_dimension_unique : forall C k m, affine_dimension C k -> affine_dimension C m -> k = m.
Proof. intros. apply Nat.le_antisymm; eapply affine_dimension_incl; eauto; apply incl_refl. Qed.

Lemma axes_span : forall v, in_span [V 1 0 0; V 0 1 0; V 0 0 1] v.
Proof. intros [x y z]. exists [x; y; z]. split; auto. apply vec_eq; simpl; ring. Qed.
Theorem affine_dimension_at_most_3 : forall C k, affine_dimension C k -> (k <= 3)%nat.
Proof.
  intros C k [p0 [B [_ [<- [I _]]]]]. apply (independent_length [V 1 0 0; V 0 1 0; V 0 0 1]); auto.
  intros. apply axes_span.
Qed.

(* Points that a plane contains have dimension 2 at most. *)
Theorem affine_dimension_in_plane : forall C k u m, affine_dimension C k -> u <> vzero ->
  (forall p, In p C -> dot u p = m) -> (k <= 2)%nat.
Proof.
  intros C k u m [p0 [B [H0 [<- [I [S _]]]]]] U H.
  assert (O : forall b, In b B -> dot u b = 0).
  { intros b Hb. destruct (S b Hb) as [p [Hp ->]]. replace 0 with (m - m) by ring.
    rewrite <- (H p Hp) at 1. rewrite <- (H p0 H0). clear. vdestruct; vunfold; ring. }
  assert (I' : independent (u :: B)).
  { apply (independent_cons B u); auto. intro E. apply U, dot_self_zero, E. }
  apply (independent_length [V 1 0 0; V 0 1 0; V 0 0 1]) in I'; [simpl in I'; lia|]. intros. apply axes_span.
Qed.

(* Where a point of D is not in the affine hull of C, a linear function parts it from C, and the dimension grows. *)
Theorem affine_dimension_grows : forall C D k m u l q, incl C D -> affine_dimension C k -> affine_dimension D m ->
  (forall p, In p C -> dot u p = l) -> In q D -> dot u q <> l -> (k < m)%nat.
Proof.
  intros C D k m u l q H [p0 [B [H0 [<- [I [S _]]]]]] [q0 [B' [H0' [<- [_ [_ G]]]]]] U Hq N.
  assert (I' : independent (vsub q p0 :: B)).
  { apply (independent_cons B u); auto.
    - intros b Hb. destruct (S b Hb) as [p [Hp ->]]. replace 0 with (l - l) by ring.
      rewrite <- (U p Hp) at 1. rewrite <- (U p0 H0). clear. vdestruct; vunfold; ring.
    - intro E. apply N. rewrite <- (U p0 H0). apply Rminus_diag_uniq. rewrite <- E. clear. vdestruct; vunfold; ring. }
  apply (independent_length B') in I'; [simpl in I'; lia|].
  intros b [<-|Hb]; [apply (basis_spans D q0 B' _ H0' G q p0); auto|].
  destruct (S b Hb) as [p [Hp E]]. apply (basis_spans D q0 B' b H0' G p p0); auto.
Qed.

(* Points of dimension 0 are one point. *)
Lemma affine_dimension_0 : forall C p q, affine_dimension C 0 -> In p C -> In q C -> p = q.
Proof.
  intros C p q [p0 [B [_ [L [_ [_ G]]]]]] Hp Hq. destruct B; [|discriminate].
  assert (Z : forall r, In r C -> r = p0).
  { intros r Hr. destruct (G r Hr) as [[|k c] [Lc E]]; [|discriminate]. simpl in E.
    transitivity (vadd p0 (vsub r p0)); [apply vec_eq; simpl; ring|]. rewrite <- E. apply vec_eq; simpl; ring. }
  rewrite (Z p), (Z q); auto.
Qed.
Lemma affine_dimension_of_one : forall C p, In p C -> (forall q, In q C -> q = p) -> affine_dimension C 0.
Proof.
  intros C p Hp H. exists p, []. repeat split; auto.
  - intros [|a c] L _; [constructor | discriminate].
  - intros b [].
  - intros q Hq. exists []. split; auto. rewrite (H q Hq). apply vec_eq; simpl; ring.
Qed.
