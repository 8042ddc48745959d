(* Convex and affine hulls of finite lists of points, and the relative interior (FC-CRIT-02).
   x is in the relative interior of conv C iff it is a convex combination with positive weights, all of them. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3.
Import ListNotations.
Open Scope R_scope.

Fixpoint sum (w : list R) : R := match w with [] => 0 | a :: w' => a + sum w' end.
Fixpoint comb (w : list R) (C : list vec) : vec :=
  match w, C with
  | a :: w', p :: C' => vadd (vscale a p) (comb w' C')
  | _, _ => vzero
  end.

Definition in_aff C x := exists w, length w = length C /\ sum w = 1 /\ comb w C = x.
Definition in_conv C x :=
  exists w, length w = length C /\ Forall (fun a => 0 <= a) w /\ sum w = 1 /\ comb w C = x.
(* The topological definition: a ball around x, as far as it lies in aff C, lies in conv C. *)
Definition in_relint C x :=
  in_conv C x /\ exists r, 0 < r /\ forall y, in_aff C y -> dist2 y x < r -> in_conv C y.
Definition has_positive_weights C x :=
  exists w, length w = length C /\ Forall (fun a => 0 < a) w /\ sum w = 1 /\ comb w C = x.

(* ---- Lists of weights ---- *)

Fixpoint ladd (u v : list R) : list R :=
  match u, v with a :: u', b :: v' => (a + b) :: ladd u' v' | _, _ => [] end.
Definition lscale k (u : list R) : list R := map (Rmult k) u.

Lemma ladd_length : forall u v n, length u = n -> length v = n -> length (ladd u v) = n.
Proof.
  induction u as [|a u IH]; intros [|b v] n Hu Hv; simpl in *; subst; try discriminate; auto.
Qed.
Lemma lscale_length : forall k u, length (lscale k u) = length u.
Proof. intros; apply map_length. Qed.
Lemma sum_ladd : forall u v, length u = length v -> sum (ladd u v) = sum u + sum v.
Proof.
  induction u as [|a u IH]; intros [|b v] H; simpl in *; try discriminate; try lra.
  rewrite IH by auto. lra.
Qed.
Lemma sum_lscale : forall k u, sum (lscale k u) = k * sum u.
Proof. unfold lscale; induction u as [|a u IH]; simpl; [lra|]. rewrite IH; lra. Qed.
Lemma comb_ladd : forall u v C, length u = length C -> length v = length C ->
  comb (ladd u v) C = vadd (comb u C) (comb v C).
Proof.
  induction u as [|a u IH]; intros [|b v] [|p C] Hu Hv; simpl in *; try discriminate.
  - apply vec_eq; simpl; lra.
  - rewrite IH by auto. apply vec_eq; simpl; lra.
Qed.
Lemma comb_lscale : forall k u C, comb (lscale k u) C = vscale k (comb u C).
Proof.
  unfold lscale; induction u as [|a u IH]; intros [|p C]; simpl; try (apply vec_eq; simpl; lra).
  rewrite IH. apply vec_eq; simpl; lra.
Qed.
Lemma comb_shift : forall x u C, length u = length C ->
  comb u (map (fun p => vsub p x) C) = vsub (comb u C) (vscale (sum u) x).
Proof.
  induction u as [|a u IH]; intros [|p C] H; simpl in *; try discriminate.
  - apply vec_eq; simpl; lra.
  - rewrite IH by auto. apply vec_eq; simpl; lra.
Qed.

(* ---- Spans: coefficients that are bounded by the length of the vector ---- *)

Definition in_span vs v := exists c, length c = length vs /\ comb c vs = v.

Lemma span_sub_scale : forall vs v w k, in_span vs v -> in_span vs w -> in_span vs (vsub v (vscale k w)).
Proof.
  intros vs v w k [c [Hc Ec]] [d [Hd Ed]].
  exists (ladd c (lscale (- k) d)). split.
  - apply ladd_length; [auto | rewrite lscale_length; auto].
  - rewrite comb_ladd, comb_lscale, Ec, Ed by (rewrite ?lscale_length; auto). apply vec_eq; simpl; lra.
Qed.

Lemma dist2_zero : forall x y, dist2 x y = 0 -> x = y.
Proof.
  intros x y H. apply dot_self_zero in H. transitivity (vadd (vsub x y) y); [apply vec_eq; simpl; ring|].
  rewrite H. apply vec_eq; simpl; ring.
Qed.
Lemma vec_eq_dec : forall a b : vec, {a = b} + {a <> b}.
Proof. decide equality; apply Req_EM_T. Qed.
Lemma cauchy_schwarz2 : forall a b, dot a b * dot a b <= dot a a * dot b b.
Proof.
  intros a b. assert (F : dot a a * dot b b - dot a b * dot a b = dot (cross a b) (cross a b)).
  { vdestruct; vunfold; ring. }
  generalize (dot_self_nonneg (cross a b)); lra.
Qed.

Lemma span_bound : forall vs,
  (exists M, 0 <= M /\ forall v, in_span vs v ->
     exists c, length c = length vs /\ comb c vs = v /\ Forall (fun k => k * k <= M * dot v v) c) /\
  (forall v, exists s, in_span vs s /\ forall t, in_span vs t -> dot (vsub v s) t = 0).
Proof.
  induction vs as [|w ws [[M [HM IHb]] IHp]].
  - split.
    + exists 0; split; [lra|]. intros v [c [Hc Ec]]. exists []; destruct c; simpl in *; try discriminate.
      repeat split; auto.
    + intros v. exists vzero. split; [exists []; auto|].
      intros t [c [Hc Ec]]. destruct c; simpl in *; try discriminate. subst t.
      vdestruct; vunfold; ring.
  - destruct (IHp w) as [s0 [Hs0 Hort]].
    set (r := vsub w s0) in *.
    destruct (Req_dec (dot r r) 0) as [Hr|Hr].
    + (* w lies in the span of the others *)
      assert (Ew : w = s0).
      { apply dot_self_zero in Hr. unfold r in Hr. clear - Hr.
        destruct w, s0; unfold vsub, vzero in Hr; simpl in Hr; injection Hr; intros; f_equal; lra. }
      assert (Sub : forall v, in_span (w :: ws) v -> in_span ws v).
      { intros v [c [Hc Ec]]. destruct c as [|k c]; simpl in *; try discriminate.
        injection Hc; intro Hc'.
        replace v with (vsub (comb c ws) (vscale (- k) w)) by (rewrite <- Ec; apply vec_eq; simpl; lra).
        apply span_sub_scale; [exists c; auto | rewrite Ew; auto]. }
      assert (Sup : forall v, in_span ws v -> in_span (w :: ws) v).
      { intros v [c [Hc Ec]]. exists (0 :: c). simpl. split; [auto|]. rewrite Ec. apply vec_eq; simpl; lra. }
      split.
      * exists M; split; [auto|]. intros v Hv. destruct (IHb v (Sub v Hv)) as [c [Hc [Ec Bc]]].
        exists (0 :: c); simpl. repeat split; [auto| |].
        -- rewrite Ec. apply vec_eq; simpl; lra.
        -- constructor; auto. generalize (Rmult_le_pos _ _ HM (dot_self_nonneg v)); lra.
      * intros v. destruct (IHp v) as [s [Hs Ho]]. exists s; split; auto.
    + (* r is a new direction, orthogonal to the others *)
      assert (Hr' : 0 < dot r r) by (generalize (dot_self_nonneg r); lra).
      assert (Split : forall v, in_span (w :: ws) v ->
        exists k s, in_span ws s /\ v = vadd (vscale k w) s /\ k = dot v r / dot r r).
      { intros v [c [Hc Ec]]. destruct c as [|k c]; simpl in *; try discriminate.
        injection Hc; intro Hc'. exists k, (comb c ws).
        assert (Hs : in_span ws (comb c ws)) by (exists c; auto).
        split; [auto|]. split; [auto|].
        assert (O1 : dot r (comb c ws) = 0) by (apply Hort; auto).
        assert (O2 : dot r s0 = 0) by (apply Hort; auto).
        assert (E : dot v r = k * dot r r + k * dot r s0 + dot r (comb c ws)).
        { rewrite <- Ec. unfold r. generalize (comb c ws). clear. intros. vdestruct; vunfold; ring. }
        rewrite E, O1, O2. field. auto. }
      split.
      * exists (/ dot r r + M * (2 * (1 + dot w w / dot r r))).
        assert (Hi : 0 < / dot r r) by (apply Rinv_0_lt_compat; auto).
        assert (Hw : 0 <= dot w w / dot r r)
          by (apply Rmult_le_pos; [apply dot_self_nonneg | lra]).
        split; [apply Rplus_le_le_0_compat; [lra | apply Rmult_le_pos; lra] |].
        intros v Hv. destruct (Split v Hv) as [k [s [Hs [Ev Ek]]]].
        destruct (IHb s Hs) as [c [Hc [Ec Bc]]].
        assert (Bk : k * k <= dot v v / dot r r).
        { rewrite Ek. replace (dot v r / dot r r * (dot v r / dot r r))
            with (dot v r * dot v r * (/ dot r r * / dot r r)) by (field; auto).
          replace (dot v v / dot r r) with (dot v v * dot r r * (/ dot r r * / dot r r)) by (field; auto).
          apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | apply cauchy_schwarz2]. }
        assert (Bs : dot s s <= 2 * (dot v v + k * k * dot w w)).
        { assert (Es : s = vsub v (vscale k w)) by (rewrite Ev; apply vec_eq; simpl; lra).
          assert (F : dot s s + dot (vadd v (vscale k w)) (vadd v (vscale k w))
                      = 2 * (dot v v + k * k * dot w w)).
          { rewrite Es. clear. vdestruct; vunfold; ring. }
          generalize (dot_self_nonneg (vadd v (vscale k w))); lra. }
        assert (Bs' : dot s s <= 2 * (1 + dot w w / dot r r) * dot v v).
        { generalize (dot_self_nonneg w); intro Ww.
          assert (k * k * dot w w <= dot v v / dot r r * dot w w) by (apply Rmult_le_compat_r; auto).
          replace (dot v v / dot r r * dot w w) with (dot w w / dot r r * dot v v) in H by (field; auto).
          clear - Bs H. lra. }
        generalize (dot_self_nonneg v); intro Vv.
        exists (k :: c); simpl. repeat split; [auto | rewrite Ec; auto |].
        constructor.
        -- replace (dot v v / dot r r) with (/ dot r r * dot v v) in Bk by (field; auto).
           assert (0 <= M * (2 * (1 + dot w w / dot r r)) * dot v v) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra |
             lra]). lra.
        -- eapply Forall_impl; [|exact Bc]. intros x Hx. cbv beta in Hx |- *.
           assert (M * dot s s <= M * (2 * (1 + dot w w / dot r r) * dot v v))
             by (apply Rmult_le_compat_l; auto).
           assert (0 <= / dot r r * dot v v) by (apply Rmult_le_pos; lra). lra.
      * intros v. destruct (IHp v) as [s [[c [Hc Ec]] Ho]].
        set (k := dot v r / dot r r). destruct Hs0 as [c0 [Hc0 Ec0]].
        exists (vadd s (vscale k r)). split.
        -- exists (k :: ladd c (lscale (- k) c0)). split.
           ++ simpl. f_equal. apply ladd_length; rewrite ?lscale_length; auto.
           ++ simpl. rewrite comb_ladd, comb_lscale, Ec, Ec0 by (rewrite ?lscale_length; auto).
              unfold r. apply vec_eq; simpl; lra.
        -- intros t Ht. destruct (Split t Ht) as [j [s' [Hs' [Et _]]]].
           assert (Hs0' : in_span ws s0) by (exists c0; auto).
           assert (Os : in_span ws s) by (exists c; auto).
           (* t = j r + (j s0 + s') *)
           assert (O1 : dot (vsub v s) s0 = 0) by auto.
           assert (O2 : dot (vsub v s) s' = 0) by auto.
           assert (O3 : dot r s0 = 0) by auto. assert (O4 : dot r s' = 0) by auto.
           assert (O5 : dot r s = 0) by auto.
           assert (E : dot (vsub v (vadd s (vscale k r))) t =
             j * (dot v r - dot r s - k * dot r r) + j * dot (vsub v s) s0 + dot (vsub v s) s'
             - k * j * dot r s0 - k * dot r s').
           { assert (Et' : t = vadd (vscale j (vadd r s0)) s')
               by (rewrite Et; unfold r; apply vec_eq; simpl; lra).
             rewrite Et'. generalize r, k. clear. intros. vdestruct; vunfold; ring. }
           rewrite E, O1, O2, O3, O4, O5. unfold k. field. auto.
Qed.

(* ---- The characterization ---- *)

Lemma forall_pos_min : forall w, Forall (fun a => 0 < a) w ->
  exists l, 0 < l /\ Forall (fun a => l <= a) w.
Proof.
  induction 1 as [|a w Ha Hw [l [Hl Fl]]].
  - exists 1; split; [lra | constructor].
  - exists (Rmin a l). split; [apply Rmin_pos; auto|].
    constructor; [apply Rmin_l|]. eapply Forall_impl; [|exact Fl].
    intros b Hb. cbv beta in *. generalize (Rmin_r a l); lra.
Qed.

Lemma sum_bound : forall c B, Forall (fun k => Rabs k <= B) c -> Rabs (sum c) <= INR (length c) * B.
Proof.
  induction 1 as [|k c Hk Hc IH].
  - simpl. rewrite Rabs_R0. lra.
  - change (length (k :: c)) with (S (length c)). rewrite S_INR. simpl sum.
    generalize (Rabs_triang k (sum c)); lra.
Qed.

Theorem positive_weights_sound : forall C x, has_positive_weights C x -> in_relint C x.
Proof.
  intros C x [w [Hw [Pw [Sw Ew]]]]. split.
  { exists w. repeat split; auto. eapply Forall_impl; [|exact Pw]. intros; cbv beta in *; lra. }
  destruct (span_bound (map (fun p => vsub p x) C)) as [[M [HM Hb]] _].
  destruct (forall_pos_min w Pw) as [l [Hl Fl]].
  set (n := INR (length C)).
  assert (Hn : 0 <= n) by apply pos_INR.
  (* all |c_i| <= B with n B <= 1/2 and B <= l/2 *)
  set (B := Rmin (/ (2 * (n + 1))) (l / 2)).
  assert (HB : 0 < B).
  { apply Rmin_pos; [apply Rinv_0_lt_compat; lra | lra]. }
  assert (HB1 : n * B <= / 2).
  { assert (B <= / (2 * (n + 1))) by apply Rmin_l.
    assert (E : / (2 * (n + 1)) * (2 * (n + 1)) = 1) by (field; lra). nra. }
  assert (HB2 : B <= l / 2) by apply Rmin_r.
  exists (B * B / (M + 1)). split.
  { apply Rdiv_lt_0_compat; nra. }
  intros y [u [Hu [Su Eu]]] Hd.
  assert (Hspan : in_span (map (fun p => vsub p x) C) (vsub y x)).
  { exists u. split; [rewrite map_length; auto|]. rewrite comb_shift, Su, Eu by auto. apply vec_eq; simpl; lra. }
  destruct (Hb _ Hspan) as [c [Hc [Ec Bc]]]. rewrite map_length in Hc.
  assert (Bc' : Forall (fun k => Rabs k <= B) c).
  { eapply Forall_impl; [|exact Bc]. intros k Hk. cbv beta in *.
    apply Rsqr_incr_0; [|apply Rabs_pos|lra]. rewrite <- Rsqr_abs. unfold Rsqr.
    fold (dist2 y x) in Hk.
    assert (E : B * B / (M + 1) * (M + 1) = B * B) by (field; lra).
    assert (0 <= dist2 y x) by apply dot_self_nonneg. nra. }
  generalize (sum_bound c B Bc'). rewrite Hc. fold n. intro HS.
  assert (HS2 : Rabs (sum c) <= / 2) by lra.
  exists (ladd (lscale (1 - sum c) w) c). repeat split.
  - apply ladd_length; rewrite ?lscale_length; auto.
  - assert (HS3 : / 2 <= 1 - sum c) by (generalize (Rle_abs (sum c)); lra).
    revert HS3. generalize (1 - sum c). intros t Ht.
    clear - Fl Bc' HB2 Ht Hl. revert c Bc'.
    induction Fl as [|a w Ha Fl IH]; intros [|k c] Bc'; simpl; constructor; inversion Bc'; subst; auto.
    assert (- B <= k) by (revert H1; unfold Rabs; destruct (Rcase_abs k); lra). nra.
  - rewrite sum_ladd, sum_lscale, Sw by (rewrite lscale_length; congruence). ring.
  - rewrite comb_ladd, comb_lscale, Ew by (rewrite ?lscale_length; auto).
    rewrite comb_shift in Ec by auto.
    assert (Ey : comb c C = vadd (vsub y x) (vscale (sum c) x)).
    { rewrite <- Ec. apply vec_eq; simpl; lra. }
    rewrite Ey. apply vec_eq; simpl; lra.
Qed.

Lemma sum_repeat : forall k n, sum (repeat k n) = INR n * k.
Proof. induction n; [simpl; lra|]. rewrite S_INR. simpl repeat. simpl sum. rewrite IHn. lra. Qed.
Lemma Forall_repeat : forall (P : R -> Prop) k n, P k -> Forall P (repeat k n).
Proof. induction n; simpl; constructor; auto. Qed.

Theorem positive_weights_complete : forall C x, in_relint C x -> has_positive_weights C x.
Proof.
  intros C x [[w [Hw [Nw [Sw Ew]]]] [r [Hr Hball]]].
  destruct C as [|p0 C'] eqn:EC.
  { destruct w; simpl in *; [lra | discriminate]. }
  rewrite <- EC in *.
  set (n := INR (length C)).
  assert (Hn : 0 < n) by (unfold n; apply lt_0_INR; rewrite EC; simpl; lia).
  set (u := repeat (/ n) (length C)).
  assert (Lu : length u = length C) by apply repeat_length.
  assert (Su : sum u = 1) by (unfold u; rewrite sum_repeat; fold n; field; lra).
  set (y := comb u C).
  set (t := Rmin 1 (r / (2 * (dist2 x y + 1)))).
  assert (Hd : 0 <= dist2 x y) by apply dot_self_nonneg.
  assert (Ht : 0 < t).
  { apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]. }
  assert (Ht1 : t <= 1) by apply Rmin_l.
  assert (Ht2 : t * dist2 x y < r).
  { assert (t <= r / (2 * (dist2 x y + 1))) by apply Rmin_r.
    assert (E : r / (2 * (dist2 x y + 1)) * (2 * (dist2 x y + 1)) = r) by (field; lra). nra. }
  set (z := vadd x (vscale t (vsub x y))).
  assert (Hz : in_aff C z).
  { exists (ladd (lscale (1 + t) w) (lscale (- t) u)). repeat split.
    - apply ladd_length; rewrite lscale_length; auto.
    - rewrite sum_ladd, !sum_lscale, Sw, Su by (rewrite !lscale_length; congruence). ring.
    - rewrite comb_ladd, !comb_lscale, Ew by (rewrite ?lscale_length; auto). fold y.
      unfold z; apply vec_eq; simpl; ring. }
  assert (Hzd : dist2 z x < r).
  { assert (E : dist2 z x = t * (t * dist2 x y)).
    { unfold z. clear. generalize y. intros. vdestruct; vunfold; ring. }
    rewrite E. nra. }
  destruct (Hball z Hz Hzd) as [v [Lv [Nv [Sv Ev]]]].
  exists (ladd (lscale (/ (1 + t)) v) (lscale (t / (1 + t)) u)). repeat split.
  - apply ladd_length; rewrite lscale_length; auto.
  - assert (Hk : 0 < / (1 + t)) by (apply Rinv_0_lt_compat; lra).
    assert (Hu : 0 < / n) by (apply Rinv_0_lt_compat; lra).
    assert (Fu : Forall (fun a => 0 < a) (lscale (t / (1 + t)) u)).
    { unfold lscale, u. apply Forall_forall. intros a Ha. apply in_map_iff in Ha.
      destruct Ha as [b [<- Hb]]. apply repeat_spec in Hb. subst b.
      apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra | lra]. }
    assert (Lvu : length v = length (lscale (t / (1 + t)) u)) by (rewrite lscale_length; congruence).
    revert Fu Lvu. generalize (lscale (t / (1 + t)) u). clear - Nv Hk.
    induction Nv as [|a v Ha Nv IH]; intros [|b l] Fu L; simpl in *; try discriminate; constructor.
    + inversion Fu; subst. assert (0 <= / (1 + t) * a) by (apply Rmult_le_pos; lra). lra.
    + apply IH; [inversion Fu; auto | lia].
  - rewrite sum_ladd, !sum_lscale, Sv, Su by (rewrite !lscale_length; congruence). field. lra.
  - rewrite comb_ladd, !comb_lscale, Ev by (rewrite ?lscale_length; auto). fold y.
    unfold z. apply vec_eq; simpl; field; lra.
Qed.

Theorem relint_iff_positive_weights : forall C x, in_relint C x <-> has_positive_weights C x.
Proof. split; [apply positive_weights_complete | apply positive_weights_sound]. Qed.
