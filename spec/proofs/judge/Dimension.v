(* Points of a grid as vectors of R^3, and the dimension of their affine hull, which the judge computes by products of
   integers: Judge.zrank is right, and so is it for points that are scaled by the grid's unit. *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.CriticalPoint spec.StationaryPoint spec.Dimension
  judge.Judge.
Import ListNotations.

Definition emb (p : zvec) : vec := V (IZR (zx p)) (IZR (zy p)) (IZR (zz p)).
Definition scaled s p := vscale s (emb p).

Ltac zunfold := unfold emb, zdet, zdist2, zdot, zcross, zsub, zadd, zscale, det, dist2, dot, cross, vsub, vadd, vscale;
  simpl;
  rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR.

Lemma emb_dot : forall a b, IZR (zdot a b) = dot (emb a) (emb b).
Proof. intros; zunfold; ring. Qed.
Lemma emb_cross : forall a b, emb (zcross a b) = cross (emb a) (emb b).
Proof. intros; zunfold; reflexivity. Qed.
Lemma emb_sub : forall a b, emb (zsub a b) = vsub (emb a) (emb b).
Proof. intros; zunfold; reflexivity. Qed.
Lemma emb_scale : forall k a, emb (zscale k a) = vscale (IZR k) (emb a).
Proof. intros. unfold emb, zscale, vscale. cbn [zx zy zz vx vy vz]. rewrite !mult_IZR. reflexivity. Qed.
Lemma emb_det : forall a b c, IZR (zdet a b c) = det (emb a) (emb b) (emb c).
Proof. intros. unfold zdet, det. rewrite emb_dot, emb_cross. reflexivity. Qed.
Lemma emb_zero : forall a, emb a = vzero <-> znonzero a = false.
Proof.
  intros [x y z]. unfold emb, znonzero, zsame, vzero; simpl. rewrite negb_false_iff, !andb_true_iff, !Z.eqb_eq. split.
  - intro H. injection H; intros Hz Hy Hx. repeat split; apply eq_IZR; assumption.
  - intros [[-> ->] ->]. reflexivity.
Qed.

Open Scope R_scope.

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

(* ---- Dimension ---- *)

Lemma find_some_or_none : forall (f : zvec -> bool) l,
  (exists d, find f l = Some d /\ In d l /\ f d = true) \/ (find f l = None /\ forall d, In d l -> f d = false).
Proof.
  intros f l. destruct (find f l) as [d|] eqn:E.
  - left. exists d. apply find_some in E. tauto.
  - right. split; auto. apply find_none, E.
Qed.

Lemma independent_1 : forall d, d <> vzero -> independent [d].
Proof.
  intros d Hd. apply (independent_cons [] d); [intros b [] | intro E; apply Hd, dot_self_zero, E |].
  intros [|a c] L _; [constructor | discriminate].
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
  intros a b H. apply (independent_cons [b] (cross b (cross a b))).
  - intros q [<-|[]]. clear. vdestruct; vunfold; ring.
  - intro E. apply H, dot_self_zero. rewrite <- E. clear. vdestruct; vunfold; ring.
  - apply independent_1. intros ->. apply H. apply vec_eq; vunfold; ring.
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
  intros c a b H. apply (independent_cons [a; b] (cross a b)).
  - intros q [<-|[<-|[]]]; clear; vdestruct; vunfold; ring.
  - intro E. apply H. rewrite <- E. clear. vdestruct; vunfold; ring.
  - apply independent_2. intro E. apply H. unfold det. rewrite E. clear. vdestruct; vunfold; ring.
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

(* ---- The same on a grid with another unit ---- *)

Lemma comb_scaled : forall s c B, comb c (map (vscale s) B) = vscale s (comb c B).
Proof.
  intros s. induction c as [|a c IH]; intros [|b B]; simpl; try (apply vec_eq; simpl; ring).
  rewrite IH. apply vec_eq; simpl; ring.
Qed.

Lemma vscale_zero : forall s v, s <> 0 -> vscale s v = vzero -> v = vzero.
Proof.
  intros s [x y z] Hs H. unfold vscale, vzero in *; simpl in *. injection H; intros.
  apply vec_eq; simpl; apply Rmult_eq_reg_l with s; auto; lra.
Qed.

Lemma affine_dimension_scaled : forall s C k, s <> 0 ->
  affine_dimension C k -> affine_dimension (map (vscale s) C) k.
Proof.
  intros s C k Hs [p0 [B [I0 [HL [HI [HB HS]]]]]].
  assert (Sub : forall a b, vsub (vscale s a) (vscale s b) = vscale s (vsub a b))
    by (intros; apply vec_eq; simpl; ring).
  exists (vscale s p0), (map (vscale s) B). split; [apply in_map; auto|]. split; [rewrite map_length; auto|].
  split; [|split].
  - intros c Lc Ec. rewrite map_length in Lc. rewrite comb_scaled in Ec. apply HI; auto. apply vscale_zero in Ec; auto.
  - intros b Hb. apply in_map_iff in Hb. destruct Hb as [a [<- Ha]]. destruct (HB a Ha) as [p [Hp ->]].
    exists (vscale s p). split; [apply in_map; auto | symmetry; apply Sub].
  - intros p Hp. apply in_map_iff in Hp. destruct Hp as [q [<- Hq]]. destruct (HS q Hq) as [c [Lc Ec]].
    exists c. split; [rewrite map_length; auto|]. rewrite Sub, comb_scaled, Ec. reflexivity.
Qed.

Lemma has_dimension_right : forall s C k, s <> 0 -> has_dimension C k = true ->
  affine_dimension (map (scaled s) C) k.
Proof.
  intros s [|p0 rest] k Hs H; [discriminate|]. unfold has_dimension in H. apply Nat.eqb_eq in H. rewrite <- H.
  unfold scaled. rewrite <- (map_map emb (vscale s)). apply affine_dimension_scaled; auto. apply zrank_spec.
Qed.
