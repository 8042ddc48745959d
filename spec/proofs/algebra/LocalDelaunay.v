(* Cells that are neighbours (FC-CERT-02): the local test of T3, and the walk of step 5 of the proof.
   Let two cells have a common facet. The apex of one is outside of the other's sphere, on it or inside, iff the other's
   apex is so of the one's sphere.
   lift z r2 is the affine function that is |x|^2 on the sphere around z of the squared radius r2.
   If no apex is inside, the lifts do not fall over a facet, and so they do not along a walk from cell to cell. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere.
Import ListNotations.
Open Scope R_scope.

Definition lift z r2 x := dot x x - power z r2 x.
Definition same_sign a b := (0 < a <-> 0 < b) /\ (a = 0 <-> b = 0) /\ (a < 0 <-> b < 0).

(* The lifts of two spheres differ by a linear function and a constant. *)
Definition gradient z z' := vscale 2 (vsub z' z).
Lemma lift_difference : forall z r2 z' r2' x,
  lift z' r2' x - lift z r2 x = dot (gradient z z') x - (dot z' z' - dot z z - r2' + r2).
Proof. intros. unfold lift, power, gradient. vdestruct; vunfold; ring. Qed.
Lemma lift_at_sample : forall z r2 p, power z r2 p = 0 -> lift z r2 p = dot p p.
Proof. intros z r2 p E. unfold lift. rewrite E. ring. Qed.

(* Both lifts are the same on the common facet. *)
Lemma lifts_on_facet : forall F z r2 z' r2' x, on_sphere z r2 F -> on_sphere z' r2' F -> in_aff F x ->
  lift z r2 x = lift z' r2' x.
Proof.
  intros F z r2 z' r2' x S S' H. apply Rminus_diag_uniq_sym. rewrite lift_difference.
  apply Rminus_diag_eq. apply (aff_level _ _ F); [|exact H]. intros p Hp.
  apply Rminus_diag_uniq. rewrite <- lift_difference. rewrite !lift_at_sample by auto. ring.
Qed.

(* ---- The local test ---- *)

Lemma multiples_same_sign : forall a b k m, 0 < k -> 0 < m -> k * a = m * b -> same_sign a b.
Proof. unfold same_sign. intros a b k m Hk Hm E. repeat split; intros; nra. Qed.

(* In any dimension: the segment from p to q passes through the affine hull of the facet F. *)
Theorem local_test : forall F p q z r2 z' r2' t,
  on_sphere z r2 (p :: F) -> on_sphere z' r2' (q :: F) ->
  0 < t < 1 -> in_aff F (vadd p (vscale t (vsub q p))) ->
  same_sign (power z r2 q) (power z' r2' p).
Proof.
  intros F p q z r2 z' r2' t S S' Ht H.
  apply (lifts_on_facet F z r2 z' r2') in H; try (intros f Hf; first [apply S | apply S']; right; exact Hf).
  apply Rminus_diag_eq in H.
  assert (Sp : dist2 z p = r2) by (apply (on_sphere_at _ _ _ p S); left; auto).
  assert (Sq : dist2 z' q = r2') by (apply (on_sphere_at _ _ _ q S'); left; auto).
  apply (multiples_same_sign _ _ t (1 - t)); [lra | lra |]. apply Rminus_diag_uniq_sym. rewrite <- H.
  unfold lift, power. rewrite <- Sp, <- Sq. clear. vdestruct; vunfold; ring.
Qed.

(* The same, seen from a sample a of the facet. *)
Lemma power_from : forall z z' a x, dist2 z x = dist2 z a ->
  power z' (dist2 z' a) x = - dot (gradient z z') (vsub x a).
Proof.
  intros z z' a x E. unfold power, gradient.
  transitivity ((dist2 z' x - dist2 z' a) - (dist2 z x - dist2 z a)); [lra|]. clear. vdestruct; vunfold; ring.
Qed.
Lemma facet_level : forall z z' a f, dist2 z f = dist2 z a -> dist2 z' f = dist2 z' a ->
  dot (gradient z z') (vsub f a) = 0.
Proof. intros z z' a f E E'. generalize (power_from z z' a f E). unfold power. lra. Qed.
Lemma gradient_back : forall z z' x, dot (gradient z' z) x = - dot (gradient z z') x.
Proof. intros. unfold gradient. vdestruct; vunfold; ring. Qed.

(* As the checkers have it, in space: the cells have positive volume, and the facet opposite orientations. *)
Theorem local_test_in_space : forall a b c p q z z',
  on_sphere z (dist2 z a) [p; b; c] -> on_sphere z' (dist2 z' a) [q; b; c] ->
  0 < volume_in_space p a b c -> 0 < volume_in_space q b a c ->
  same_sign (power z (dist2 z a) q) (power z' (dist2 z' a) p).
Proof.
  intros a b c p q z z' S S' P Q.
  assert (D := fun f => on_sphere_at _ _ _ f S). assert (D' := fun f => on_sphere_at _ _ _ f S').
  apply (multiples_same_sign _ _ (volume_in_space p a b c) (volume_in_space q b a c)); auto. clear P Q.
  rewrite (power_from z z' a p), (power_from z' z a q), gradient_back; [|apply D' | apply D]; simpl; auto.
  assert (B : dot (gradient z z') (vsub b a) = 0) by (apply facet_level; [apply D | apply D']; simpl; auto).
  assert (C : dot (gradient z z') (vsub c a) = 0) by (apply facet_level; [apply D | apply D']; simpl; auto).
  revert B C. generalize (gradient z z'). clear. intros g B C. apply Rminus_diag_uniq.
  transitivity (dot g (vsub c a) * det (vsub p a) (vsub q a) (vsub b a)
                - dot g (vsub b a) * det (vsub p a) (vsub q a) (vsub c a)); [|rewrite B, C; ring].
  clear. unfold volume_in_space. vdestruct; vunfold; ring.
Qed.

(* So it does not matter which of the two the checker asks. *)
Corollary either_test_in_space : forall a b c p q,
  0 < volume_in_space p a b c -> 0 < volume_in_space q b a c ->
  same_sign (lifted_in_space p a b c q) (lifted_in_space q b a c p).
Proof.
  intros a b c p q P Q.
  destruct (tetrahedron_sphere_right p a b c q P) as [A [B [C _]]].
  destruct (tetrahedron_sphere_right q b a c p Q) as [B' [A' [C' _]]].
  set (z := centre_at p _) in *. set (z' := centre_at q _) in *. clearbody z z'.
  rewrite (lifted_in_space_power p a b c z), (lifted_in_space_power q b a c z') by auto. rewrite <- A, <- A'.
  destruct (local_test_in_space a b c p q z z') as [H1 [H2 H3]]; auto;
    try (intros f Hf; apply Rminus_diag_eq; destruct Hf as [<-|[<-|[<-|[]]]]; congruence).
  set (v := volume_in_space p a b c) in *. set (v' := volume_in_space q b a c) in *.
  set (x := power z _ q) in *. set (x' := power z' _ p) in *. clearbody v v' x x'. clear - P Q H1 H2 H3.
  assert (M : forall m y, 0 < m -> (0 < m * y <-> 0 < y) /\ (m * y = 0 <-> y = 0) /\ (m * y < 0 <-> y < 0)).
  { intros. repeat split; intros; nra. }
  destruct (M v x P) as [M1 [M2 M3]]. destruct (M v' x' Q) as [N1 [N2 N3]]. unfold same_sign. tauto.
Qed.

(* In a plane, where both cells lie. *)
Theorem local_test_in_plane : forall m a b p q z z',
  on_sphere z (dist2 z a) [p; b] -> on_sphere z' (dist2 z' a) [q; b] ->
  det (vsub b a) (vsub p a) (vsub q a) = 0 ->
  0 < volume_in_plane m p a b -> 0 < volume_in_plane m q b a ->
  same_sign (power z (dist2 z a) q) (power z' (dist2 z' a) p).
Proof.
  intros m a b p q z z' S S' F P Q.
  assert (D := fun f => on_sphere_at _ _ _ f S). assert (D' := fun f => on_sphere_at _ _ _ f S').
  apply (multiples_same_sign _ _ (volume_in_plane m p a b) (volume_in_plane m q b a)); auto. clear P Q.
  rewrite (power_from z z' a p), (power_from z' z a q), gradient_back; [|apply D' | apply D]; simpl; auto.
  assert (B : dot (gradient z z') (vsub b a) = 0) by (apply facet_level; [apply D | apply D']; simpl; auto).
  revert B F. generalize (gradient z z'). clear. intros g B F. apply Rminus_diag_uniq.
  transitivity (dot m g * det (vsub b a) (vsub p a) (vsub q a)
                - dot g (vsub b a) * dot m (cross (vsub p a) (vsub q a))); [|rewrite B, F; ring].
  clear. unfold volume_in_plane. vdestruct; vunfold; ring.
Qed.

(* On a line: the facet is the sample a. *)
Theorem local_test_on_line : forall m a p q z z',
  dist2 z p = dist2 z a -> dist2 z' q = dist2 z' a -> cross (vsub p a) (vsub q a) = vzero ->
  0 < volume_on_line m p a -> volume_on_line m q a < 0 ->
  same_sign (power z (dist2 z a) q) (power z' (dist2 z' a) p).
Proof.
  intros m a p q z z' S S' F P Q.
  apply (multiples_same_sign _ _ (volume_on_line m p a) (- volume_on_line m q a)); [exact P | lra |]. clear P Q.
  rewrite (power_from z z' a p), (power_from z' z a q), gradient_back by auto.
  revert F. generalize (gradient z z'). clear. intros g F. apply Rminus_diag_uniq.
  transitivity (dot (cross g m) (cross (vsub p a) (vsub q a))); [|rewrite F; apply dot_vzero].
  clear. unfold volume_on_line. vdestruct; vunfold; ring.
Qed.

(* ---- The walk ---- *)

Record cell := Cell { samples : list vec; centre : vec; radius2 : R }.
Definition cell_lift c x := lift (centre c) (radius2 c) x.
Definition has_sphere c := on_sphere (centre c) (radius2 c) (samples c).
(* The slope of the lift in the direction u. *)
Definition slope c u := 2 * dot (centre c) u.
Lemma slope_right : forall c x u k, cell_lift c (vadd x (vscale k u)) = cell_lift c x + k * slope c u.
Proof. intros. unfold cell_lift, lift, power, slope. generalize (centre c). intros. vdestruct; vunfold; ring. Qed.

(* s and t have the common facet F, and q is opposite to it in t. T3 says that q is not strictly inside the sphere
   of s. *)
Definition next s t F q := incl F (samples s) /\ incl F (samples t) /\ In q (samples t) /\
  (forall p, In p (samples t) -> p = q \/ In p F) /\ radius2 s <= dist2 (centre s) q.

(* On the facet's affine hull both lifts are equal. The next cell's lift is not the smaller one on that cell, nor
   anywhere on its side of the facet, where one comes from the facet's affine hull by a way towards q. *)
Theorem step : forall s t F q, has_sphere s -> has_sphere t -> next s t F q ->
  (forall x, in_aff F x -> cell_lift s x = cell_lift t x) /\
  (forall x, in_conv (samples t) x -> cell_lift s x <= cell_lift t x) /\
  (forall f f0 k, in_aff F f -> in_aff F f0 -> 0 <= k ->
    let x := vadd f (vscale k (vsub q f0)) in cell_lift s x <= cell_lift t x).
Proof.
  intros s t F q S T [Fs [Ft [Tq [Q N]]]].
  assert (E0 : forall x, in_aff F x -> cell_lift s x = cell_lift t x).
  { intros x Hx. apply (lifts_on_facet F); [| |exact Hx]; intros p Hp; auto. }
  split; [exact E0|]. split.
  - intros x Hx. assert (D : forall p, In p (samples t) -> cell_lift s p <= cell_lift t p).
    { intros p Hp. unfold cell_lift at 2. rewrite lift_at_sample by auto.
      destruct (Q p Hp) as [->|Hf]; [unfold cell_lift, lift, power; lra|].
      unfold cell_lift. rewrite lift_at_sample by auto. lra. }
    apply Rminus_le. unfold cell_lift in *. assert (E := lift_difference (centre t) (radius2 t) (centre s) (radius2 s)).
    rewrite E. apply Rle_minus. apply (conv_below _ _ (samples t)); [|exact Hx].
    intros p Hp. specialize (D p Hp). specialize (E p). lra.
  - intros f f0 k Hf Hf0 Hk x. apply E0 in Hf, Hf0. apply Rminus_le.
    assert (Dq : cell_lift s q - cell_lift t q <= 0).
    { unfold cell_lift. rewrite (lift_at_sample (centre t)) by auto. unfold lift, power. lra. }
    apply Rminus_diag_eq in Hf, Hf0.
    apply Rle_trans with ((cell_lift s f - cell_lift t f)
      + k * ((cell_lift s q - cell_lift t q) - (cell_lift s f0 - cell_lift t f0))).
    + right. unfold cell_lift. rewrite !lift_difference. unfold x. generalize (gradient (centre t) (centre s)).
      intros g. clear. vdestruct; vunfold; ring.
    + rewrite Hf, Hf0. nra.
Qed.

(* Over a facet, in a direction that leads into the next cell, the slope does not fall. *)
Theorem step_slope : forall s t F q x u k, has_sphere s -> has_sphere t -> next s t F q ->
  in_aff F x -> 0 < k -> in_conv (samples t) (vadd x (vscale k u)) -> slope s u <= slope t u.
Proof.
  intros s t F q x u k S T N Hx Hk Hc. destruct (step s t F q S T N) as [E [L _]].
  apply E in Hx. apply L in Hc. rewrite !slope_right, Hx in Hc. nra.
Qed.

(* The segment from y to x goes from cell s, where it is from the time a on, to cell e, where it ends at the time 1.
   At a time between a and 1 it goes through a common facet to the next cell. *)
Definition at_time y x a := vadd y (vscale a (vsub x y)).
Inductive walk y x : R -> cell -> cell -> Prop :=
| last_cell : forall a e, a < 1 -> has_sphere e -> in_conv (samples e) x -> walk y x a e e
| crossing : forall a b s t F q e, a < b -> has_sphere s -> next s t F q -> in_conv F (at_time y x b) ->
    walk y x b t e -> walk y x a s e.

(* In the first cell there is a later point of the segment. *)
Lemma walk_start : forall y x a s e, walk y x a s e ->
  has_sphere s /\ exists b, a < b <= 1 /\ in_conv (samples s) (at_time y x b).
Proof.
  intros y x a s e H. induction H as [a e Ha S Hx | a b s t F q e Hb S N Hc W [_ [b' [Hb' _]]]]; split; auto.
  - exists 1. split; [lra|]. replace (at_time y x 1) with x; auto. apply vec_eq; simpl; ring.
  - exists b. split; [lra|]. apply (conv_incl F); auto. destruct N as [Fs _]. exact Fs.
Qed.

(* Along the segment the slope never falls, and at its end the lift of the last cell is not smaller than that of the
   first. *)
Theorem walk_rises : forall y x a s e, walk y x a s e ->
  slope s (vsub x y) <= slope e (vsub x y) /\ cell_lift s x <= cell_lift e x.
Proof.
  intros y x a s e H. induction H as [a e Ha S Hx | a b s t F q e Hb S N Hc W [IS IL]]; [split; lra|].
  destruct (walk_start _ _ _ _ _ W) as [T [b' [Hb' Hc']]].
  assert (Move : forall k l, at_time y x l = vadd (at_time y x k) (vscale (l - k) (vsub x y))).
  { intros. unfold at_time. apply vec_eq; simpl; ring. }
  assert (K : slope s (vsub x y) <= slope t (vsub x y)).
  { apply (step_slope s t F q (at_time y x b) _ (b' - b)); auto; [apply conv_in_aff; auto | lra |].
    rewrite <- Move. exact Hc'. }
  split; [lra|]. apply Rle_trans with (cell_lift t x); [|exact IL].
  replace x with (at_time y x 1) by (apply vec_eq; simpl; ring).
  rewrite (Move b 1), !slope_right. destruct (step s t F q S T N) as [E _].
  rewrite (E (at_time y x b)) by (apply conv_in_aff; auto).
  assert (0 <= 1 - b) by lra. nra.
Qed.

(* So a sample of the last cell is not strictly inside the sphere of the first cell, if the walk ends there. *)
Corollary walk_outside : forall y x a s e, walk y x a s e -> In x (samples e) -> has_sphere e ->
  radius2 s <= dist2 (centre s) x.
Proof.
  intros y x a s e W Hx E. apply walk_rises in W. destruct W as [_ L].
  unfold cell_lift at 2 in L. rewrite lift_at_sample in L by auto. unfold cell_lift, lift, power in L. lra.
Qed.
