(* Affine functions on space, sums over the points of a list, and small steps.
   What holds of an affine function at some points holds at their convex combinations. *)
From Coq Require Import Reals Lra Lia List Psatz.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere.
Import ListNotations.
Open Scope R_scope.

(* ---- Affine functions ---- *)

Definition affine (h : vec -> R) := exists g c, forall x, h x = dot g x + c.
(* The point of a segment: y at a = 0, x at a = 1. *)
Definition mix (a : R) (y x : vec) : vec := vadd (vscale (1 - a) y) (vscale a x).

Lemma affine_mix : forall h a y x, affine h -> h (mix a y x) = (1 - a) * h y + a * h x.
Proof. intros h a y x [g [c H]]. rewrite !H. unfold mix. vdestruct; vunfold; ring. Qed.
Lemma affine_scale : forall h k, affine h -> affine (fun x => k * h x).
Proof. intros h k [g [c H]]. exists (vscale k g), (k * c). intro x. rewrite H. vdestruct; vunfold; ring. Qed.
Lemma affine_minus : forall f h, affine f -> affine h -> affine (fun x => f x - h x).
Proof.
  intros f h [g [c H]] [g' [c' H']]. exists (vsub g g'), (c - c'). intro x. rewrite H, H'. vdestruct; vunfold; ring.
Qed.
Lemma affine_const : forall k, affine (fun _ => k).
Proof. intros k. exists vzero, k. intro x. vdestruct; vunfold; ring. Qed.
Lemma affine_vx : affine vx.
Proof. exists (V 1 0 0), 0. intro x. vdestruct; vunfold; ring. Qed.
Lemma affine_vy : affine vy.
Proof. exists (V 0 1 0), 0. intro x. vdestruct; vunfold; ring. Qed.
Lemma affine_vz : affine vz.
Proof. exists (V 0 0 1), 0. intro x. vdestruct; vunfold; ring. Qed.

Lemma mix_mix : forall a e y x, mix e (mix a y x) x = mix (a + e * (1 - a)) y x.
Proof. intros. unfold mix. apply vec_eq; vdestruct; vunfold; ring. Qed.
Lemma mix_0 : forall y x, mix 0 y x = y.
Proof. intros. unfold mix. apply vec_eq; vdestruct; vunfold; ring. Qed.
Lemma mix_1 : forall y x, mix 1 y x = x.
Proof. intros. unfold mix. apply vec_eq; vdestruct; vunfold; ring. Qed.

(* ---- Powers: two of them differ by an affine function ---- *)

Lemma power_difference : forall z r2 y s2, affine (fun x => power z r2 x - power y s2 x).
Proof.
  intros z r2 y s2. exists (vscale 2 (vsub y z)), (dot z z - dot y y - r2 + s2).
  intro x. unfold power. vdestruct; vunfold; ring.
Qed.

(* ---- Convex combinations ---- *)

Lemma affine_comb : forall h C w, affine h -> length w = length C ->
  sum w = 1 -> h (comb w C) = sum (map (fun '(a, p) => a * h p) (combine w C)).
Proof.
  intros h C w [g [c H]] L S.
  assert (G : forall w C, length w = length C ->
    dot g (comb w C) + c * sum w = sum (map (fun '(a, p) => a * h p) (combine w C))).
  { clear - H. induction w as [|a w IH]; intros [|p C] L; try discriminate; simpl.
    - vdestruct; vunfold; ring.
    - rewrite <- IH by (simpl in L; congruence). rewrite H. generalize (comb w C); intros.
      vdestruct; vunfold; ring. }
  rewrite H, <- G by auto. rewrite S. ring.
Qed.

Lemma hull_nonneg : forall h C x, affine h -> (forall p, In p C -> 0 <= h p) -> in_conv C x -> 0 <= h x.
Proof.
  intros h C x Ah H [w [L [N [S E]]]]. rewrite <- E, affine_comb by auto.
  clear Ah S E x. revert C H L. induction N as [|a w Ha N IH]; intros [|p C] H L; try discriminate; simpl; try lra.
  assert (0 <= a * h p) by (apply Rmult_le_pos; auto; apply H; left; auto).
  assert (0 <= sum (map (fun '(a, p) => a * h p) (combine w C))); [|lra].
  apply IH; [intros; apply H; right; auto | simpl in L; congruence].
Qed.
Lemma hull_equal : forall f h C x, affine f -> affine h -> (forall p, In p C -> f p = h p) -> in_conv C x -> f x = h x.
Proof.
  intros f h C x Af Ah H Hx.
  assert (0 <= f x - h x).
  { apply (hull_nonneg (fun x => f x - h x) C); auto using affine_minus. intros p Hp. rewrite H; auto; lra. }
  assert (0 <= h x - f x).
  { apply (hull_nonneg (fun x => h x - f x) C); auto using affine_minus. intros p Hp. rewrite H; auto; lra. }
  lra.
Qed.
Lemma hull_mix : forall C a y x, 0 <= a <= 1 -> in_conv C y -> in_conv C x -> in_conv C (mix a y x).
Proof.
  intros C a y x Ha Hy Hx. replace (mix a y x) with (vadd y (vscale a (vsub x y))); [apply conv_between; auto|].
  unfold mix. apply vec_eq; simpl; ring.
Qed.

(* ---- Sums over the points of a list ---- *)

Definition total (u : list vec) (f : vec -> R) : R := sum (map f u).

Lemma total_ext : forall u f g, (forall v, In v u -> f v = g v) -> total u f = total u g.
Proof.
  intros u f g. unfold total. induction u as [|v u IH]; simpl; intro H; auto.
  rewrite IH by auto. rewrite H by auto. reflexivity.
Qed.
Lemma total_zero : forall u f, (forall v, In v u -> f v = 0) -> total u f = 0.
Proof.
  intros u f. unfold total. induction u as [|v u IH]; simpl; intro H; auto. rewrite IH, H by auto. lra.
Qed.
Lemma total_scale : forall u k f, total u (fun v => k * f v) = k * total u f.
Proof. intros. unfold total. induction u; simpl; [lra|]. rewrite IHu. ring. Qed.
Lemma total_nonneg : forall u f, (forall v, In v u -> 0 <= f v) -> 0 <= total u f.
Proof.
  intros u f. unfold total. induction u as [|v u IH]; simpl; intro H; [lra|].
  generalize (H v (or_introl eq_refl)). assert (0 <= sum (map f u)) by auto. lra.
Qed.
Lemma total_nonneg_zero : forall u f, (forall v, In v u -> 0 <= f v) -> total u f = 0 -> forall v, In v u -> f v = 0.
Proof.
  intros u f. unfold total. induction u as [|v u IH]; simpl; intros H S w; [intros []|].
  assert (0 <= sum (map f u)) by (apply total_nonneg; auto). generalize (H v (or_introl eq_refl)). intro Hv.
  intros [<-|Hw]; [lra|]. apply IH; auto. lra.
Qed.
Lemma total_one : forall u v f, NoDup u -> In v u -> (forall w, In w u -> w <> v -> f w = 0) -> total u f = f v.
Proof.
  intros u v f. unfold total. induction 1 as [|w u Hw N IH]; [intros []|]. simpl.
  intros [->|Hv] H.
  - fold (total u f). rewrite total_zero; [lra|]. intros x Hx. apply H; auto. congruence.
  - rewrite IH by auto. rewrite H; auto; [lra|]. congruence.
Qed.
Lemma affine_total : forall u (b : vec -> vec -> R) (k : vec -> R),
  (forall v, In v u -> affine (b v)) -> affine (fun x => total u (fun v => b v x * k v)).
Proof.
  intros u b k. unfold total. induction u as [|v u IH]; intro H; simpl; [apply affine_const|].
  destruct (H v (or_introl eq_refl)) as [g [c Hg]]. destruct IH as [g' [c' Hg']]; [intros; apply H; right; auto|].
  exists (vadd (vscale (k v) g) g'), (k v * c + c'). intro x. rewrite Hg', Hg. vdestruct; vunfold; ring.
Qed.

(* ---- What holds of all small steps ---- *)

Definition soon (Q : R -> Prop) := exists e, 0 < e <= 1 /\ forall t, 0 < t < e -> Q t.

Lemma soon_and : forall Q S, soon Q -> soon S -> soon (fun t => Q t /\ S t).
Proof.
  intros Q S [e [He HQ]] [f [Hf HS]]. exists (Rmin e f). split.
  - split; [apply Rmin_pos; lra|]. generalize (Rmin_l e f); lra.
  - intros t Ht. generalize (Rmin_l e f), (Rmin_r e f). intros. split; [apply HQ | apply HS]; lra.
Qed.
Lemma soon_all : forall A (l : list A) (Q : A -> R -> Prop), (forall x, In x l -> soon (Q x)) ->
  soon (fun t => forall x, In x l -> Q x t).
Proof.
  intros A l Q. induction l as [|x l IH]; intro H.
  - exists 1. split; [lra|]. intros t _ x [].
  - destruct (soon_and _ _ (H x (or_introl eq_refl)) (IH (fun y Hy => H y (or_intror Hy)))) as [e [He Hs]].
    exists e. split; auto. intros t Ht y Hy. destruct (Hs t Ht) as [H1 H2]. destruct Hy as [<-|Hy]; auto.
Qed.
Lemma soon_some : forall Q, soon Q -> exists t, 0 < t < 1 /\ Q t.
Proof. intros Q [e [He H]]. exists (e / 2). split; [lra|]. apply H; lra. Qed.
Lemma soon_below : forall a b c m, a < m -> soon (fun t => a + t * b + t * t * c < m).
Proof.
  intros a b c m H. set (k := Rabs b + Rabs c + 1).
  assert (Hb : b <= Rabs b) by apply Rle_abs. assert (Hc : c <= Rabs c) by apply Rle_abs.
  assert (Pb : 0 <= Rabs b) by apply Rabs_pos. assert (Pc : 0 <= Rabs c) by apply Rabs_pos.
  assert (Hk : 0 < k) by (unfold k; lra).
  assert (Hm : 0 < (m - a) / k) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin 1 ((m - a) / k)). split; [split; [apply Rmin_pos; lra | apply Rmin_l]|].
  intros t Ht. generalize (Rmin_l 1 ((m - a) / k)), (Rmin_r 1 ((m - a) / k)). intros M1 M2.
  assert (T : t * k < m - a).
  { replace (m - a) with ((m - a) / k * k) by (field; lra). apply Rmult_lt_compat_r; lra. }
  assert (t * b <= t * Rabs b) by (apply Rmult_le_compat_l; lra).
  assert (t * t * c <= t * Rabs c).
  { rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
    apply Rle_trans with (t * Rabs c); [apply Rmult_le_compat_l; lra|].
    rewrite <- (Rmult_1_l (Rabs c)) at 2. apply Rmult_le_compat_r; lra. }
  unfold k in T. lra.
Qed.
Lemma soon_positive : forall h y x, affine h -> 0 < h y -> soon (fun t => 0 < h (mix t y x)).
Proof.
  intros h y x Ah H. destruct (soon_below (- h y) (h y - h x) 0 0) as [e [He Hs]]; [lra|].
  exists e. split; auto. intros t Ht. rewrite affine_mix by auto. generalize (Hs t Ht). lra.
Qed.
Lemma soon_nonzero : forall h y x, affine h -> h y <> 0 -> soon (fun t => h (mix t y x) <> 0).
Proof.
  intros h y x Ah H. destruct (Rlt_or_le 0 (h y)) as [P|P].
  - destruct (soon_positive h y x Ah P) as [e [He Hs]]. exists e. split; auto. intros t Ht.
    apply Rgt_not_eq. apply Hs; auto.
  - destruct (soon_positive (fun x => -1 * h x) y x) as [e [He Hs]]; [apply affine_scale; auto | lra |].
    exists e. split; auto. intros t Ht E. generalize (Hs t Ht). rewrite E. lra.
Qed.
Lemma soon_near : forall y x z m, dist2 y z < m -> soon (fun t => dist2 (mix t y x) z < m).
Proof.
  intros y x z m H. destruct (soon_below _ (2 * dot (vsub x y) (vsub y z)) (dot (vsub x y) (vsub x y)) m H)
    as [e [He Hs]].
  exists e. split; auto. intros t Ht. generalize (Hs t Ht). intro G.
  replace (dist2 (mix t y x) z) with
    (dist2 y z + t * (2 * dot (vsub x y) (vsub y z)) + t * t * dot (vsub x y) (vsub x y)); auto.
  unfold mix. clear. vdestruct; vunfold; ring.
Qed.

(* ---- What holds near a point ---- *)

Lemma affine_near : forall h x, affine h -> 0 < h x -> exists e, 0 < e /\ forall z, dist2 z x < e -> 0 < h z.
Proof.
  intros h x [g [c H]] P. assert (G : 0 <= dot g g) by apply dot_self_nonneg.
  exists (h x * h x / (dot g g + 1)). split; [apply Rdiv_lt_0_compat; nra|].
  intros z Hz. assert (E : h z = h x + dot g (vsub z x)).
  { rewrite !H. clear. vdestruct; vunfold; ring. }
  rewrite E. generalize (cauchy_schwarz2 g (vsub z x)). fold (dist2 z x). intro CS.
  assert (D : 0 <= dist2 z x) by apply dot_self_nonneg.
  assert (B : dist2 z x * (dot g g + 1) < h x * h x).
  { replace (h x * h x) with (h x * h x / (dot g g + 1) * (dot g g + 1)) by (field; lra).
    apply Rmult_lt_compat_r; lra. }
  set (s := dot g (vsub z x)) in *. assert (s * s < h x * h x) by nra.
  apply Rnot_le_lt. intro L. assert (h x <= - s) by lra. nra.
Qed.
Lemma all_near : forall (hs : list (vec -> R)) x, (forall h, In h hs -> affine h) ->
  exists e, 0 < e /\ forall h z, In h hs -> 0 < h x -> dist2 z x < e -> 0 < h z.
Proof.
  intros hs x. induction hs as [|h hs IH]; intro A.
  - exists 1. split; [lra|]. intros h z [].
  - destruct IH as [e [He Hs]]; [intros; apply A; right; auto|].
    destruct (Rlt_or_le 0 (h x)) as [P|P].
    + destruct (affine_near h x (A h (or_introl eq_refl)) P) as [f [Hf Hh]].
      exists (Rmin e f). split; [apply Rmin_pos; lra|]. intros k z Hk Pk Hz.
      generalize (Rmin_l e f), (Rmin_r e f). intros. destruct Hk as [<-|Hk]; [apply Hh; lra | apply Hs; auto; lra].
    + exists e. split; auto. intros k z [<-|Hk] Pk Hz; [lra | apply Hs; auto].
Qed.

(* ---- Weights on fewer points ---- *)

Lemma dist2_mix : forall a y x z e, 0 <= a <= 1 -> dist2 y z < e -> dist2 x z < e -> dist2 (mix a y x) z < e.
Proof.
  intros a y x z e Ha Hy Hx.
  assert (E : dist2 (mix a y x) z = (1 - a) * dist2 y z + a * dist2 x z - a * (1 - a) * dot (vsub x y) (vsub x y)).
  { unfold mix. clear. vdestruct; vunfold; ring. }
  assert (0 <= a * (1 - a) * dot (vsub x y) (vsub x y)) by
    (apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply dot_self_nonneg]).
  assert (0 <= (1 - a) * (e - dist2 y z)) by (apply Rmult_le_pos; lra).
  destruct (Req_dec a 0) as [->|N]; [lra|].
  assert (0 < a * (e - dist2 x z)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma dist2_refl : forall x, dist2 x x = 0.
Proof. intro x. vdestruct; vunfold; ring. Qed.

Lemma total_filter : forall u (f : vec -> bool) g, (forall v, In v u -> f v = false -> g v = 0) ->
  total (filter f u) g = total u g.
Proof.
  intros u f g. unfold total. induction u as [|v u IH]; simpl; intro H; auto.
  destruct (f v) eqn:E; simpl; rewrite IH by auto; auto. rewrite (H v) by auto. lra.
Qed.
Lemma comb_total : forall (w : vec -> R) s,
  comb (map w s) s = V (total s (fun v => w v * vx v)) (total s (fun v => w v * vy v)) (total s (fun v => w v * vz v)).
Proof. intros w s. unfold total. induction s as [|v s IH]; simpl; auto. rewrite IH. reflexivity. Qed.
