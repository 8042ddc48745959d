(* What the oracle finds by its search over subsets of at most four samples: stationary points and drivers.
   Caratheodory's theorem: a point of a hull is a combination, with positive weights, of points that are affinely
   independent, so that they are at most four. Each point of the face around it can be kept. *)
From Coq Require Import Reals ZArith Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint spec.Dimension spec.Face
  spec.Stationary spec.Driver.
Import ListNotations.
Open Scope R_scope.

Definition affinely_independent C :=
  forall c, length c = length C -> sum c = 0 -> comb c C = vzero -> Forall (fun a => a = 0) c.

(* ---- Points are independent, or a combination says how they depend ---- *)

Lemma in_aff_or_apart : forall C p, in_aff C p \/ exists r l, (forall q, In q C -> dot r q = l) /\ dot r p <> l.
Proof.
  intros [|p0 C] p.
  - right. exists vzero, 1. split; [intros q [] | vdestruct; vunfold; lra].
  - destruct (span_or_apart (map (fun q => vsub q p0) (p0 :: C)) (vsub p p0)) as [[c [L E]]|[r [O N]]].
    + left. rewrite map_length in L. destruct (unit_weights (p0 :: C) p0 (or_introl eq_refl)) as [e [Le [_ [Se Ee]]]].
      exists (ladd c (lscale (1 - sum c) e)). repeat split.
      * apply ladd_length; rewrite ?lscale_length; auto.
      * rewrite sum_ladd, sum_lscale, Se by (rewrite lscale_length; congruence). ring.
      * rewrite comb_ladd, comb_lscale, Ee by (rewrite ?lscale_length; auto). rewrite comb_shift in E by auto.
        transitivity (vadd (vsub p p0) p0); [rewrite <- E|]; apply vec_eq; simpl; ring.
    + right. assert (D : forall q, dot r (vsub q p0) = dot r q - dot r p0) by (intros; vdestruct; vunfold; ring).
      exists r, (dot r p0). split.
      * intros q Hq. apply Rminus_diag_uniq. rewrite <- D.
        apply O, span_of, in_map_iff. exists q. auto.
      * intros E. apply N. rewrite D, E. ring.
Qed.

Lemma independent_or_not : forall C, affinely_independent C \/
  exists c, length c = length C /\ sum c = 0 /\ comb c C = vzero /\ ~ Forall (fun a => a = 0) c.
Proof.
  induction C as [|p C [I|[c [L [S [E N]]]]]].
  - left. intros [|a c] L _ _; [constructor | discriminate].
  - destruct (in_aff_or_apart C p) as [[w [L [S E]]]|[r [l [O N]]]].
    + right. exists (-1 :: w). simpl. rewrite L, S, E. repeat split; [ring | apply vec_eq; simpl; ring |].
      intros F. inversion F. lra.
    + left. intros [|a c] L S E; [discriminate|]. simpl in L. injection L; intro L'. simpl in S.
      assert (Z : a = 0).
      { apply (f_equal (dot r)) in E. rewrite dot_comb_cons, dot_vzero, (comb_level r l) in E by auto.
        assert (Z : a * (dot r p - l) = 0) by (replace (sum c) with (- a) in E by lra; lra).
        apply Rmult_integral in Z. destruct Z; [auto | lra]. }
      subst a. constructor; auto. apply I; auto; [lra|]. rewrite <- E. simpl. apply vec_eq; simpl; ring.
  - right. exists (0 :: c). simpl. rewrite L, S, E. repeat split; [ring | apply vec_eq; simpl; ring |].
    intros F. inversion F; auto.
Qed.

Lemma independent_at_most_4 : forall C, affinely_independent C -> (length C <= 4)%nat.
Proof.
  intros [|p C] I; [simpl; lia|]. simpl. apply le_n_S. rewrite <- (map_length (fun q => vsub q p)).
  apply (independent_length [V 1 0 0; V 0 1 0; V 0 0 1]); [intros; apply axes_span|].
  intros c L E. rewrite map_length in L. rewrite comb_shift in E by auto.
  assert (F : Forall (fun a => a = 0) (- sum c :: c)).
  { apply I; simpl; [auto | ring |]. rewrite <- E. apply vec_eq; simpl; ring. }
  inversion F; auto.
Qed.

(* ---- Caratheodory's theorem ---- *)

Lemma below_zero : forall c, sum c = 0 -> ~ Forall (fun a => a = 0) c -> exists a, In a c /\ a < 0.
Proof.
  intros c S N. destruct (Forall_dec (fun a => 0 <= a) (Rle_dec 0) c) as [P|P].
  - exfalso. apply N. clear N.
    assert (G : forall c, Forall (fun a => 0 <= a) c -> 0 <= sum c) by (induction 1; simpl; lra).
    induction P as [|a c Ha P IH]; constructor; generalize (G c P); simpl in S; [lra|]. intros. apply IH. lra.
  - clear - P. induction c as [|a c IH]; [exfalso; apply P; constructor|].
    destruct (Rle_dec 0 a) as [A|A]; [|exists a; split; [left; auto | lra]].
    destruct IH as [b [Hb B]]; [intros F; apply P; constructor; auto|]. exists b. split; [right|]; auto.
Qed.

(* Weights that are not all positive can be changed by a multiple of c, so that one becomes negative. *)
Lemma negative_somewhere : forall w c, length w = length c -> Forall (fun a => 0 <= a) w ->
  (exists a, In a c /\ a < 0) -> exists k, 0 < k /\ ~ Forall (fun a => 0 <= a) (ladd w (lscale k c)).
Proof.
  induction w as [|b w IH]; intros [|a c] L N [d [Hd D]]; try discriminate; [destruct Hd|].
  inversion N; subst. destruct Hd as [->|Hd].
  - exists ((b + 1) / - d). split; [apply Rdiv_lt_0_compat; lra|]. intros F. simpl in F. inversion F; subst.
    assert (b + (b + 1) / - d * d = -1) by (field; lra). lra.
  - destruct (IH c) as [k [Pk Hk]]; [auto | auto | exists d; auto |]. exists k. split; auto.
    intros F. apply Hk. simpl in F. inversion F; auto.
Qed.

Lemma all_positive_or_zero : forall w, Forall (fun a => 0 <= a) w -> Forall (fun a => 0 < a) w \/ In 0 w.
Proof.
  induction 1 as [|a w Ha N [P|Z]]; [left; constructor | | right; right; auto].
  destruct (Rle_lt_or_eq_dec 0 a Ha) as [A|<-]; [left; constructor; auto | right; left; auto].
Qed.

Theorem caratheodory : forall C x, in_conv C x ->
  exists D, incl D C /\ affinely_independent D /\ (length D <= 4)%nat /\ has_positive_weights D x.
Proof.
  intros C. remember (length C) as n eqn:Hn. revert C Hn. induction n as [|n IH]; intros C Hn x X.
  { apply hull_nonempty in X. destruct X as [p Hp]. destruct C; [destruct Hp | discriminate]. }
  assert (Fewer : forall D, In D (without_one C) -> in_conv D x ->
    exists D, incl D C /\ affinely_independent D /\ (length D <= 4)%nat /\ has_positive_weights D x).
  { intros D HD HX. apply without_one_right in HD. destruct HD as [L I].
    destruct (IH D ltac:(lia) x HX) as [E [J R]]. exists E. split; auto. intros p Hp. auto. }
  destruct X as [w [L [N [S E]]]].
  destruct (independent_or_not C) as [I|[c [Lc [Sc [Ec Nc]]]]].
  - destruct (all_positive_or_zero w N) as [P|Z].
    + exists C. split; [apply incl_refl|]. split; auto. split; [apply independent_at_most_4; auto|]. exists w. auto.
    + destruct (drop_zero C w L N Z) as [D [v [HD [Lv [Nv [Sv Ev]]]]]]. apply (Fewer D HD). exists v.
      rewrite Sv, Ev. auto.
  - destruct (negative_somewhere w c) as [k [_ Hk]]; [congruence | auto | apply below_zero; auto |].
    destruct (way_out C w (ladd w (lscale k c))) as [s [D [_ [HD X]]]]; auto.
    + apply ladd_length; rewrite ?lscale_length; auto.
    + rewrite sum_ladd, sum_lscale, Sc, S by (rewrite lscale_length; congruence). ring.
    + apply (Fewer D HD). replace x with (vadd (comb w C) (vscale s (vsub (comb (ladd w (lscale k c)) C) (comb w C)))).
      * exact X.
      * rewrite comb_ladd, comb_lscale, Ec, E by (rewrite ?lscale_length; auto). apply vec_eq; simpl; ring.
Qed.

(* Where p has a positive weight, it can be kept. *)
Lemma caratheodory_with : forall C p a w x, length w = length C -> 0 < a -> Forall (fun b => 0 <= b) w ->
  a + sum w = 1 -> vadd (vscale a p) (comb w C) = x ->
  exists D, incl D C /\ affinely_independent (p :: D) /\ has_positive_weights (p :: D) x.
Proof.
  intros C. remember (length C) as n eqn:Hn. revert C Hn. induction n as [|n IH]; intros C Hn p a w x L A N S E.
  { destruct C; [|discriminate]. destruct w; [|discriminate]. exists []. split; [intros q []|]. split.
    - intros [|b [|]] Lb Sb _; try discriminate. simpl in Sb. repeat constructor. lra.
    - exists [a]. repeat split; auto. }
  (* a weight of 0 in the list leaves a shorter one *)
  assert (Fewer : forall b v, 0 < b -> length v = length C -> Forall (fun b => 0 <= b) v -> In 0 v -> b + sum v = 1 ->
    vadd (vscale b p) (comb v C) = x ->
    exists D, incl D C /\ affinely_independent (p :: D) /\ has_positive_weights (p :: D) x).
  { intros b v B Lv Nv Z Sv Ev. destruct (drop_zero C v Lv Nv Z) as [D [v' [HD [Lv' [Nv' [Sv' Ev']]]]]].
    apply without_one_right in HD. destruct HD as [LD ID].
    destruct (IH D ltac:(lia) p b v' x) as [D' [I R]]; auto; [lia | congruence | congruence |].
    exists D'. split; auto. intros q Hq. auto. }
  destruct (independent_or_not (p :: C)) as [I|[c [Lc [Sc [Ec Nc]]]]].
  - destruct (all_positive_or_zero w N) as [P|Z]; [|apply (Fewer a w); auto; congruence].
    exists C. split; [apply incl_refl|]. split; auto. exists (a :: w). simpl. repeat split; auto. congruence.
  - (* c or its opposite does not take from the weight of p *)
    assert (Up : exists b d, 0 <= b /\ length d = length C /\ b + sum d = 0 /\ vadd (vscale b p) (comb d C) = vzero /\
      ~ Forall (fun a => a = 0) (b :: d)).
    { destruct c as [|b d]; [discriminate|]. simpl in *. destruct (Rle_dec 0 b) as [B|B].
      - exists b, d. repeat split; auto.
      - exists (- b), (lscale (-1) d). rewrite lscale_length, sum_lscale, comb_lscale. repeat split; auto; try lra.
        + transitivity (vscale (-1) (vadd (vscale b p) (comb d C))); [apply vec_eq; simpl; ring|].
          rewrite Ec. apply vec_eq; simpl; ring.
        + intros F. inversion F. lra. }
    destruct Up as [b [d [B [Ld [Sd [Ed Nd]]]]]].
    assert (Neg : exists e, In e d /\ e < 0).
    { destruct (below_zero (b :: d)) as [e [[->|He] Le]]; auto; [lra | exists e; auto]. }
    destruct (negative_somewhere w d) as [k [Pk Hk]]; [congruence | auto | auto |].
    destruct (exit_time w (ladd w (lscale k d))) as [s [Hs [M Z]]]; auto.
    { symmetry. apply ladd_length; rewrite ?lscale_length; congruence. }
    set (v := ladd w (lscale k d)) in *.
    assert (Lw : length w = length C) by congruence.
    assert (Lv : length v = length C) by (apply ladd_length; rewrite ?lscale_length; auto).
    assert (Sv : sum v = sum w + k * sum d)
      by (unfold v; rewrite sum_ladd, sum_lscale by (rewrite lscale_length; congruence); ring).
    assert (Ev : comb v C = vadd (comb w C) (vscale k (comb d C)))
      by (unfold v; rewrite comb_ladd, comb_lscale by (rewrite ?lscale_length; auto); auto).
    destruct Z as [->|Z].
    { exfalso. apply Hk. rewrite mix_1 in M by congruence. exact M. }
    apply (Fewer (a + s * k * b) (mix s w v)); auto.
    + assert (0 <= s * k * b) by (repeat apply Rmult_le_pos; lra). lra.
    + apply ladd_length; rewrite lscale_length; auto.
    + unfold mix. rewrite sum_ladd, !sum_lscale, Sv by (rewrite !lscale_length; congruence).
      replace (sum d) with (- b) by lra. lra.
    + unfold mix. rewrite comb_ladd, !comb_lscale, Ev by (rewrite ?lscale_length; auto).
      transitivity (vadd (vadd (vscale a p) (comb w C)) (vscale (s * k) (vadd (vscale b p) (comb d C))));
        [apply vec_eq; simpl; ring|]. rewrite Ed, E. apply vec_eq; simpl; ring.
Qed.

(* ---- What the searches find ---- *)

(* x is inside of the simplex D, and as far from each of its points. *)
Definition inner_centre D x :=
  affinely_independent D /\ (length D <= 4)%nat /\ has_positive_weights D x /\
  forall p q, In p D -> In q D -> dist2 x p = dist2 x q.

(* The stationary points are the inner centres of samples that are nearest to them. *)
Theorem stationary_by_search : forall P x,
  is_stationary P x <-> exists D, inner_centre D x /\ forall p, In p D -> nearest P x p.
Proof.
  intros P x. destruct (contact_set_exists P x) as [K H]. destruct (contact_points_exist P x K H) as [C HC].
  assert (HN := contact_points P x K C H HC). split.
  - intros [L [HL [C' [HC' X]]]]. destruct (caratheodory C' x X) as [D [I [A [L4 W]]]]. exists D.
    assert (Nr : forall p, In p D -> nearest P x p) by (intros p Hp; apply (contact_points P x L C' HL HC'), I, Hp).
    split; auto. repeat split; auto. intros p q Hp Hq. apply Nr in Hp, Hq.
    apply Rle_antisym; [apply Hp, Hq | apply Hq, Hp].
  - intros [D [[_ [_ [W _]]] Nr]]. exists K. split; auto. exists C. split; auto.
    apply (conv_incl D); [intros p Hp; apply HN, Nr, Hp|]. apply positive_weights_sound, W.
Qed.

(* The driver is an inner centre of contact points, and none of these centres is nearer to x. *)
Theorem driver_by_search : forall P x c C, contacts P x C ->
  (driver P x c <-> (exists D, incl D C /\ inner_centre D c) /\
     forall D y, incl D C -> inner_centre D y -> dist2 x c <= dist2 x y).
Proof.
  intros P x c C HC.
  assert (Half : forall c, driver P x c -> (exists D, incl D C /\ inner_centre D c) /\
     forall D y, incl D C -> inner_centre D y -> dist2 x c <= dist2 x y).
  { clear c. intros c [C' [HC' N']].
    assert (N : nearest_in_hull C x c).
    { apply (nearest_same C'); auto; intros p Hp; [apply HC, HC', Hp | apply HC', HC, Hp]. }
    split.
    - destruct (caratheodory C c (proj1 N)) as [D [I [A [L4 W]]]]. exists D. split; auto. repeat split; auto.
      assert (An := proj1 (nearest_iff_angles C x c (proj1 N)) N).
      assert (Lv : forall p, In p D -> dot (vsub x c) p = dot (vsub x c) c).
      { apply (touching (vsub x c) (dot (vsub x c) c) D c); auto; [apply positive_weights_sound, W|].
        intros p Hp. specialize (An p (I p Hp)). apply Rminus_le.
        replace (dot (vsub x c) p - dot (vsub x c) c) with (dot (vsub x c) (vsub p c)); auto.
        clear. vdestruct; vunfold; ring. }
      intros p q Hp Hq. assert (Ep := Lv p Hp). assert (Eq := Lv q Hq).
      assert (E : dist2 x p = dist2 x q).
      { apply I, HC in Hp. apply I, HC in Hq. apply Rle_antisym; [apply Hp, Hq | apply Hq, Hp]. }
      revert E Ep Eq. clear. vdestruct; vunfold. lra.
    - intros D y I [_ [_ [W _]]]. apply N. apply (conv_incl D); auto. apply positive_weights_sound, W. }
  split; [apply Half|]. intros [[D [I IC]] Le].
  assert (X : in_conv C c).
  { destruct IC as [_ [_ [W _]]]. apply (conv_incl D); auto. apply positive_weights_sound, W. }
  destruct (hull_nonempty C c X) as [p Hp].
  assert (HP : P <> []) by (intros ->; apply HC in Hp; destruct Hp as [[] _]).
  destruct (driver_exists P x HP) as [c' Hc']. destruct (Half c' Hc') as [[D' [I' IC']] _].
  exists C. split; auto. split; auto. intros y Hy. destruct Hc' as [C' [HC' [_ N']]].
  apply Rle_trans with (dist2 x c'); [apply (Le D'); auto|]. apply N', (conv_incl C); auto.
  intros q Hq. apply HC', HC, Hq.
Qed.

(* The face that has x in its relative interior has those points of C that are in a simplex around x. *)
Theorem face_by_search : forall C x F, face C F -> in_relint F x -> forall p,
  (In p F <->
   exists D, In p D /\ incl D C /\ affinely_independent D /\ (length D <= 4)%nat /\ has_positive_weights D x).
Proof.
  intros C x F [_ [u [m [B A]]]] [X [r [Hr Ball]]] p.
  assert (Sub : incl F C) by (intros q Hq; apply A; auto). split.
  - intros Hp. set (d := dist2 x p). assert (Hd : 0 <= d) by apply dot_self_nonneg.
    (* a little beyond x, seen from p, the hull of F goes on *)
    set (t := Rmin 1 (r / (2 * (d + 1)))).
    assert (Ht : 0 < t) by (apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]).
    assert (Ht1 : t <= 1) by apply Rmin_l.
    assert (Htd : t * d < r).
    { assert (t <= r / (2 * (d + 1))) by apply Rmin_r.
      assert (r / (2 * (d + 1)) * (2 * (d + 1)) = r) by (field; lra). nra. }
    set (y := vadd x (vscale t (vsub x p))).
    destruct (Ball y) as [v [Lv [Nv [Sv Ev]]]].
    + destruct X as [w [L [_ [S E]]]]. destruct (unit_weights F p Hp) as [e [Le [_ [Se Ee]]]].
      exists (ladd (lscale (1 + t) w) (lscale (- t) e)). repeat split.
      * apply ladd_length; rewrite lscale_length; auto.
      * rewrite sum_ladd, !sum_lscale, S, Se by (rewrite !lscale_length; congruence). ring.
      * rewrite comb_ladd, !comb_lscale, E, Ee by (rewrite ?lscale_length; auto). unfold y. apply vec_eq; simpl; ring.
    + assert (E : dist2 y x = t * (t * d)) by (unfold y, d; clear; generalize t; intros; vdestruct; vunfold; ring).
      rewrite E. nra.
    + assert (Ti : 0 < / (1 + t)) by (apply Rinv_0_lt_compat; lra).
      destruct (caratheodory_with F p (t * / (1 + t)) (lscale (/ (1 + t)) v) x) as [D [I [Ind W]]].
      * rewrite lscale_length; auto.
      * apply Rmult_lt_0_compat; auto.
      * apply nonneg_lscale; [lra | auto].
      * rewrite sum_lscale, Sv. field. lra.
      * rewrite comb_lscale, Ev. unfold y. apply vec_eq; simpl; field; lra.
      * exists (p :: D). split; [left; auto|]. split; [intros q [<-|Hq]; auto|]. split; auto.
        split; [apply independent_at_most_4; auto | auto].
  - intros [D [Hp [I [_ [_ W]]]]]. apply A. split; auto.
    apply (touching u m D x); auto; [apply positive_weights_sound, W|].
    apply (aff_level u m F); [intros q Hq; apply A; auto | apply conv_in_aff; auto].
Qed.
