(* The centre that the checker computes is that of the smallest sphere through a simplex, and its test of a point and
   its weights are those of real numbers. *)
From Coq Require Import Reals ZArith Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Affine.
Import ListNotations.
Open Scope R_scope.
Local Arguments Z.mul : simpl never.
Local Arguments Z.add : simpl never.
Local Arguments Z.sub : simpl never.

Definition centre_of (s : list zvec) : vec :=
  let '(toward, k) := centre_of_edges (edges s) in
  vadd (emb (origin s)) (vscale (/ (2 * IZR k)) (emb toward)).
Definition scale_of (s : list zvec) : Z := snd (centre_of_edges (edges s)).
Definition radius2_of (s : list zvec) : R := dist2 (emb (origin s)) (centre_of s).

Lemma outside_power : forall s p, scale_of s <> 0%Z ->
  IZR (outside s p) = IZR (scale_of s) * IZR (scale_of s) * power (centre_of s) (radius2_of s) (emb p).
Proof.
  intros s p. unfold radius2_of, scale_of, outside, centre_of, power. destruct (centre_of_edges (edges s)) as [t k].
  simpl snd. intro H. assert (K : IZR k <> 0) by (intro E; apply eq_IZR in E; auto).
  rewrite mult_IZR, minus_IZR, mult_IZR, !emb_dot, emb_sub.
  assert (I : 2 * IZR k * / (2 * IZR k) = 1) by (field; auto).
  set (i := / (2 * IZR k)) in *. clearbody i. clear K H. revert I.
  generalize (emb p) (emb (origin s)) (emb t) (IZR k). clear. intros p o t K I.
  transitivity (K * K * dot (vsub p o) (vsub p o) - (2 * K * i) * K * dot t (vsub p o)).
  - rewrite I. ring.
  - clear. vdestruct; vunfold; ring.
Qed.

(* ---- All of its samples are on the sphere ---- *)

Ltac zunfold_all := unfold outside, centre_of_edges, edges, origin, zdet, zdot, zcross, zadd, zscale, zsub; simpl.

Lemma outside_self : forall s p, (2 <= length s <= 4)%nat -> In p s -> outside s p = 0%Z.
Proof.
  intros s p L H. destruct s as [|o [|a [|b [|c [|d s]]]]]; simpl in L; try lia;
    repeat (destruct H as [<-|H]; [zunfold_all; ring|]); [destruct H ..].
Qed.
Lemma centre_on_sphere : forall s p, (2 <= length s <= 4)%nat -> scale_of s <> 0%Z -> In p s ->
  power (centre_of s) (radius2_of s) (emb p) = 0.
Proof.
  intros s p L K H. generalize (outside_power s p K). rewrite outside_self by auto. intro E. symmetry in E.
  assert (N : IZR (scale_of s) <> 0) by (intro F; apply eq_IZR in F; auto).
  destruct (Rmult_integral _ _ E) as [F|F]; auto. destruct (Rmult_integral _ _ F); contradiction.
Qed.

(* ---- Its weights ---- *)

Lemma zvec_eq : forall a b, zx a = zx b -> zy a = zy b -> zz a = zz b -> a = b.
Proof. intros [] [] H1 H2 H3. simpl in *. congruence. Qed.
Ltac zvectors := unfold zdet, zdot, zcross, zadd, zscale, zsub; simpl; ring.

Lemma zcramer : forall a b c t, zadd (zscale (zdot t (zcross b c)) a) (zadd (zscale (zdot t (zcross c a)) b)
  (zscale (zdot t (zcross a b)) c)) = zscale (zdet a b c) t.
Proof. intros. apply zvec_eq; zvectors. Qed.

Lemma weights_sum : forall s, (2 <= length s <= 4)%nat -> zsum (centre_weights s) = (2 * scale_of s * scale_of s)%Z.
Proof.
  intros s L. destruct s as [|o [|a [|b [|c [|d s]]]]]; simpl in L; try lia; unfold centre_weights, scale_of;
    [reflexivity | |]; destruct (centre_of_edges (edges _)) as [t k] eqn:E; simpl; ring.
Qed.
Lemma weights_comb : forall s, (2 <= length s <= 4)%nat -> zcomb (centre_weights s) s =
  zadd (zscale (2 * scale_of s * scale_of s) (origin s)) (zscale (scale_of s) (fst (centre_of_edges (edges s)))).
Proof.
  intros s L. destruct s as [|o [|p [|q [|r [|d s]]]]]; simpl in L; try lia; unfold centre_weights, scale_of, origin.
  - simpl. apply zvec_eq; zvectors.
  - simpl edges. set (a := zsub p o). set (b := zsub q o). simpl centre_of_edges. cbv beta iota zeta. simpl fst.
      simpl snd.
    set (c := zcross a b). set (t := zadd _ _).
    assert (T : zdot t c = 0%Z) by (unfold t, c; zvectors).
    assert (K : zdet a b c = zdot c c) by (unfold c; zvectors).
    generalize (zcramer a b c t). fold c. rewrite T, K. intro E.
    assert (P : p = zadd o a) by (unfold a; apply zvec_eq; zvectors).
    assert (Q : q = zadd o b) by (unfold b; apply zvec_eq; zvectors).
    rewrite P, Q, <- E. generalize (zdot t (zcross b c)), (zdot t (zcross c a)), (zdot c c). clear. intros.
    apply zvec_eq; simpl; ring.
  - simpl edges. set (a := zsub p o). set (b := zsub q o). set (c := zsub r o). simpl centre_of_edges.
    cbv beta iota zeta. simpl fst. simpl snd. set (t := zadd _ _). generalize (zcramer a b c t). intro E.
    assert (P : p = zadd o a) by (unfold a; apply zvec_eq; zvectors).
    assert (Q : q = zadd o b) by (unfold b; apply zvec_eq; zvectors).
    assert (W : r = zadd o c) by (unfold c; apply zvec_eq; zvectors).
    rewrite <- E, P, Q, W.
    generalize (zdot t (zcross b c)), (zdot t (zcross c a)), (zdot t (zcross a b)), (zdet a b c). clear. intros.
    apply zvec_eq; simpl; ring.
Qed.

Definition real_weights s := map (fun a => IZR a / IZR (2 * scale_of s * scale_of s)) (centre_weights s).
Lemma centre_is_comb : forall s, (2 <= length s <= 4)%nat -> scale_of s <> 0%Z ->
  length (real_weights s) = length (map emb s) /\ sum (real_weights s) = 1 /\
  comb (real_weights s) (map emb s) = centre_of s.
Proof.
  intros s L H. unfold real_weights.
  assert (K : IZR (scale_of s) <> 0) by (intro E; apply eq_IZR in E; auto).
  assert (N : IZR (2 * scale_of s * scale_of s) <> 0).
  { rewrite !mult_IZR. intro E. destruct (Rmult_integral _ _ E) as [F|F]; auto. lra. }
  split; [|split].
  - rewrite !map_length. destruct s as [|o [|a [|b [|c [|d s]]]]]; simpl in L; try lia; reflexivity.
  - rewrite emb_sum, weights_sum by auto. field. auto.
  - rewrite emb_comb, weights_comb by auto. unfold centre_of. unfold scale_of in *.
    destruct (centre_of_edges (edges s)) as [t k]. simpl fst in *. simpl snd in *. unfold emb, zadd, zscale. simpl.
    apply vec_eq; simpl; rewrite !plus_IZR, !mult_IZR; field; auto.
Qed.
