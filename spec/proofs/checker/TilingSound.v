(* All samples are on the inner side of each facet without a mate, and some inner point of a cell is in no other cell:
   the cells of a certificate that the checker accepts are glued well (step 4 of the proof of FC-CERT-02).
   The proof walks from cell to cell out of the hull: the facet through which it gets out tells where that is. *)
From Coq Require Import Reals ZArith Lra Lia List Bool Permutation Classical.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere
  judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.Affine checker.Volumes checker.Tiling checker.Sound checker.Checked
  checker.HullFan.
From Flowcert Require Import checker.HullSound checker.Delaunay.
Import ListNotations.
Local Arguments Z.mul : simpl never.
Local Arguments Z.add : simpl never.
Local Arguments Z.sub : simpl never.
Open Scope R_scope.

Lemma least_of : forall (l : list vec) (h : vec -> R) p, In p l -> exists q, In q l /\ forall r, In r l -> h q <= h r.
Proof.
  intros l h. induction l as [|a l IH]; intros p Hp; [destruct Hp|].
  destruct l as [|b l]; [exists a; split; [left; auto|]; intros r [->|[]]; lra|].
  destruct (IH b (or_introl eq_refl)) as [q [Hq Le]]. destruct (Rle_or_lt (h a) (h q)) as [H|H].
  - exists a. split; [left; auto|]. intros r [->|Hr]; [lra|]. generalize (Le r Hr). lra.
  - exists q. split; [right; auto|]. intros r [<-|Hr]; [lra | auto].
Qed.
Lemma facet_eq : forall f g : facet, {f = g} + {f <> g}.
Proof. repeat (decide equality). Qed.
Lemma affine_after : forall h k m, affine h -> affine (fun x => h (vsub (vscale k x) m)).
Proof.
  intros h k m [g [c H]]. exists (vscale k g), (c - dot g m). intro x. rewrite H. vdestruct; vunfold; ring.
Qed.

Lemma conv_level : forall d N o C x, (forall p, In p C -> level d N o p) -> in_conv C x -> level d N o x.
Proof.
  intros d N o C x H Hx.
  assert (Zero : forall g, (forall p, In p C -> dot g (vsub p o) = 0) -> dot g (vsub x o) = 0).
  { intros g Hg. apply (hull_equal (fun x => dot g (vsub x o)) (fun _ => 0) C); auto using affine_const.
    apply (affine_plane _ g o). auto. }
  unfold level in *. destruct d as [|[|[|k]]]; auto.
  assert (Part : forall p, cross N (vsub p o) = V (dot (V 0 (- vz N) (vy N)) (vsub p o))
    (dot (V (vz N) 0 (- vx N)) (vsub p o)) (dot (V (- vy N) (vx N) 0) (vsub p o))).
  { intro p. apply vec_eq; vdestruct; vunfold; ring. }
  rewrite Part. rewrite !Zero; auto; intros p Hp; generalize (H p Hp); rewrite Part; unfold vzero; intro E;
    injection E; auto.
Qed.

Section TilingSound.
Variable rows : list zvec.
Variable first : simplex.
Variable cells : list simplex.
Hypothesis acc : accepted rows first cells.
Hypothesis checked : hull_checked rows first cells.
Let n := normal (places rows first).
Let hull := hull_facets (facets cells).
Let rays := rays rows first.
Let cone := cone rows first.
Let in_directions := in_directions rows first.
Let depth := depth rows first.
Let P := samples rows.
Let real_cells := map (real rows) cells.
Let b := coordinate (emb n).
Let in_level := in_level rows first.
Let PL : proper_cells in_level affine P real_cells b := accepted_proper_level rows first cells acc.
Let FP := fan_proper rows first cells acc checked.
Let m := IZR (Z.of_nat (length first)).

(* From o, as many times as long as the first cell has samples. *)
Definition from_o (x : vec) : vec := vsub (vscale m x) (emb (middle rows first)).
Definition middle_point : vec := vscale (/ m) (emb (middle rows first)).

Lemma m_positive : 0 < m.
Proof. apply IZR_lt. generalize (first_length rows first cells acc). lia. Qed.
Lemma from_o_sample : forall p, from_o (emb (place rows p)) = emb (toward rows first p).
Proof.
  intro p. unfold from_o, toward, from_middle, emb, zsub, zscale, m. apply vec_eq; simpl;
    rewrite minus_IZR, mult_IZR; reflexivity.
Qed.
Lemma from_o_affine : forall h, affine h -> affine (fun x => h (from_o x)).
Proof. intros h A. apply affine_after. auto. Qed.
Lemma from_o_middle : from_o middle_point = vzero.
Proof.
  generalize m_positive. intro H. unfold from_o, middle_point. apply vec_eq; simpl; field; lra.
Qed.
Lemma middle_level : in_level middle_point.
Proof.
  assert (Lf : forall q, In q first -> in_level (emb (place rows q))).
  { intros q Hq. apply (sample_level rows first cells acc). apply (in_map (fun i => emb (place rows i))).
    apply (acc_names _ _ _ acc first); auto. apply (acc_first _ _ _ acc). }
  revert Lf. generalize (first_length rows first cells acc). unfold in_level, Sound.in_level, middle_point, m, middle.
  generalize (emb (origin (places rows first))) as o, (emb (normal (places rows first))) as N.
  clear. intros o N. destruct first as [|q0 [|q1 [|q2 [|q3 [|q4 c]]]]]; simpl; intro L; try lia; intro Lf.
  - assert (L0 := Lf q0 ltac:(auto)). assert (L1 := Lf q1 ltac:(auto)). unfold places. simpl.
    transitivity (vscale (/ 2) (vadd (cross N (vsub (emb (place rows q0)) o)) (cross N (vsub (emb (place rows q1))
      o)))).
    + unfold emb, zadd. simpl. rewrite !plus_IZR. clear. apply vec_eq; vunfold; field.
    + rewrite L0, L1. apply vec_eq; vunfold; ring.
  - assert (L0 := Lf q0 ltac:(auto)). assert (L1 := Lf q1 ltac:(auto)). assert (L2 := Lf q2 ltac:(auto 6)).
    unfold places. simpl. transitivity (/ 3 * (dot N (vsub (emb (place rows q0)) o) +
      dot N (vsub (emb (place rows q1)) o) + dot N (vsub (emb (place rows q2)) o))).
    + unfold emb, zadd. simpl. rewrite !plus_IZR. clear. vunfold; field.
    + rewrite L0, L1, L2. ring.
Qed.
Lemma from_o_level : forall x, in_level x -> in_directions (from_o x).
Proof.
  intros x Hx. assert (Ho := middle_level). assert (M := m_positive).
  assert (E : from_o x = vscale m (vsub x middle_point)).
  { unfold from_o, middle_point. apply vec_eq; simpl; field; lra. }
  rewrite E. clear E M. unfold in_directions, HullFan.in_directions, in_level, Sound.in_level in *.
  revert Hx Ho. unfold level. fold n.
  generalize (emb n) as N, (emb (origin (places rows first))) as o, middle_point as w, m as k. clear.
  intros N o w k. destruct (length first - 1)%nat as [|[|[|j]]]; auto; intros Hx Ho.
  - transitivity (vsub (vscale k (cross N (vsub x o))) (vscale k (cross N (vsub w o)))).
    + apply vec_eq; vdestruct; vunfold; ring.
    + rewrite Hx, Ho. apply vec_eq; vunfold; ring.
  - transitivity (k * dot N (vsub x o) - k * dot N (vsub w o)).
    + vdestruct; vunfold; ring.
    + rewrite Hx, Ho. ring.
Qed.

Definition marked (u : list vec) (v : vec) := exists k c i, nth_error cells k = Some c /\ (i < length c)%nat /\
  u = real rows c /\ v = emb (place rows (nth i c 0%nat)) /\ In (facet_at k c i) hull.
Lemma pairs_marked : paired_cells real_cells b marked.
Proof.
  split.
  - apply (accepted_other_side rows first cells acc).
  - apply (accepted_one_behind rows first cells acc).
  - intros u v Hu Hv. apply in_real_cells in Hu. destruct Hu as [c [Hc ->]].
    destruct (in_real rows c v Hv) as [i [B ->]]. destruct (in_cells_number cells c Hc) as [k Hk].
    destruct (accepted_paired rows first cells acc k c i Hk B) as [H|H]; [left; auto|].
    right. exists k, c, i. auto.
Qed.

(* A point of a facet without a mate is in the cone over it, and on its plane. *)
Lemma facet_point : forall k c i q, nth_error cells k = Some c -> (i < length c)%nat -> In (facet_at k c i) hull ->
  in_cell in_level b (real rows c) q -> b (real rows c) (emb (place rows (nth i c 0%nat))) q = 0 ->
  in_cell in_directions cone (rays (facet_at k c i)) (from_o q) /\ depth (rays (facet_at k c i)) (from_o q) = 0.
Proof.
  intros k c i q Hk B Hf [Lq Iq] Z. set (g := facet_at k c i) in *.
  assert (Hc : In c cells) by (eapply nth_error_In; eauto).
  assert (Hu : In (real rows c) real_cells) by (apply in_real_cells; eauto).
  assert (Hg : In (rays g) (fan rows first cells)) by (apply in_fan; eauto).
  assert (Corner : forall w, In w (real rows c) -> w <> emb (place rows (nth i c 0%nat)) -> In (from_o w) (rays g)).
  { intros w Hw D. apply in_map_iff in Hw. destruct Hw as [p [<- Hp]]. rewrite from_o_sample.
    apply (in_map (fun p => emb (toward rows first p))). change (vertices g) with (without i c).
    apply (in_without rows first cells acc); auto. split; auto. congruence. }
  split; [split|].
  - apply from_o_level. auto.
  - intros v Hv. assert (Lc := coord_lin FP (rays g) v Hg Hv).
    rewrite (expand PL (real rows c) (fun x => cone (rays g) v (from_o x)) q) by
      (auto; apply from_o_affine; apply Lc).
    apply total_nonneg. intros w Hw. destruct (vec_eq_dec w (emb (place rows (nth i c 0%nat)))) as [->|D].
    + rewrite Z. lra.
    + apply Rmult_le_pos; auto. destruct (vec_eq_dec (from_o w) v) as [->|N].
      * rewrite (coord_one FP) by auto. lra.
      * rewrite (coord_zero FP) by auto. lra.
  - rewrite (expand PL (real rows c) (fun x => depth (rays g) (from_o x)) q) by
      (auto; apply from_o_affine; apply (depth_affine rows first cells checked); auto).
    apply total_zero. intros w Hw. destruct (vec_eq_dec w (emb (place rows (nth i c 0%nat)))) as [->|D].
    + rewrite Z. ring.
    + rewrite (depth_ray rows first cells checked g) by auto. ring.
Qed.

(* A point beyond all samples is in no cell. *)
Lemma beyond : forall h k x s, affine h -> (forall p, In p P -> k <= h p) -> In s real_cells ->
  in_cell in_level b s x ->
  k <= h x.
Proof.
  intros h k x s Ah Le Hs [Lx Ix].
  assert (0 <= h x - k); [|lra].
  rewrite (expand PL s (fun x => h x - k) x) by (auto; apply affine_minus; auto using affine_const).
  apply total_nonneg. intros v Hv. apply Rmult_le_pos; auto.
  generalize (Le v (cell_points PL s Hs v Hv)). lra.
Qed.

Theorem samples_inside : forall f p, In f hull -> In p P -> 0 <= depth (rays f) (from_o p).
Proof.
  intros f p0 Hf Hp0. set (h := fun x => depth (rays f) (from_o x)).
  assert (Ah : affine h) by (apply from_o_affine; apply (depth_affine rows first cells checked); auto).
  destruct (least_of P h p0 Hp0) as [p [Hp Least]].
  apply Rnot_lt_le. intro Neg. assert (Np : h p < 0) by (generalize (Least p0 Hp0); fold (h p0) in Neg; lra).
  destruct (all_in_cells _ _ (accepted_local rows first cells acc) p Hp) as [t [Ht It]].
  (* a sample of the facet, and a point beyond p *)
  destruct (hull_facet cells f Hf) as [k [c [i [Hk [Hc [B [Ef Vf]]]]]]].
  destruct (hull_vertices rows first cells acc f Hf) as [_ [Lv Nv]].
  assert (Hw : In (nth 0 (vertices f) 0%nat) (vertices f))
    by (apply nth_In; generalize (first_length rows first cells acc); lia).
  set (j := nth 0 (vertices f) 0%nat) in *. set (w := emb (place rows j)).
  assert (Pw : In w P) by (apply (in_map (fun i => emb (place rows i))); auto).
  assert (Zw : h w = 0).
  { unfold h, w. rewrite from_o_sample. apply (depth_ray rows first cells checked f); auto.
    apply (in_map (fun p => emb (toward rows first p))). auto. }
  set (z0 := mix 2 w p).
  assert (Lz : in_level z0).
  { unfold z0, in_level, Sound.in_level. apply level_mix; apply (sample_level rows first cells acc); auto. }
  assert (Hz : h z0 < h p) by (unfold z0; rewrite affine_mix, Zw by auto; lra).
  destruct (affine_near (fun x => h p - h x) z0) as [e1 [He1 N1]];
    [apply affine_minus; auto using affine_const | lra |].
  destruct (affine_near (fun x => -1 * h x) p) as [e2 [He2 N2]]; [apply affine_scale; auto | lra |].
  destruct (generic_near PL in_level (in_cell in_level b t) z0 p (Rmin e1 e2)) as [z [y [Lz' [Iy [Dz [Dy G]]]]]]; auto.
  { eapply movable_space; eauto. }
  { eapply movable_cell; eauto. }
  { eapply vertex_in_cell; eauto. }
  { apply Rmin_pos; auto. }
  generalize (Rmin_l e1 e2), (Rmin_r e1 e2). intros M1 M2.
  assert (Hz' : h z < h p) by (generalize (N1 z ltac:(lra)); lra).
  assert (Hy : h y < 0) by (generalize (N2 y ltac:(lra)); lra).
  destruct (walk_ends PL marked pairs_marked y z t Ht G Lz' Iy) as [a [s [Hs [_ [E|E]]]]].
  - generalize (beyond h (h p) z s Ah Least Hs E). lra.
  - destruct E as [v [a' [Ba [Hv [[k' [c' [i' [Hk' [B' [-> [-> Hg]]]]]]] [Iq [Zq _]]]]]]].
    destruct (facet_point k' c' i' _ Hk' B' Hg Iq Zq) as [Cone Plane].
    generalize (least_depth rows first cells acc checked _ f _ Hg Hf Cone). fold depth rays. rewrite Plane.
    fold (h (mix a' y z)). rewrite affine_mix by auto. intro Le.
    assert (0 < (1 - a') * - h y) by (apply Rmult_lt_0_compat; lra).
    assert (0 < a' * - h z) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* ---- A point of one cell alone ---- *)

(* The mean of the samples of a facet. *)
Definition mean (f : facet) : vec :=
  comb (repeat (/ INR (length (vertices f))) (length (vertices f))) (real rows (vertices f)).

Lemma mean_value : forall f h, In f hull -> linear h ->
  h (from_o (mean f)) = / INR (length (vertices f)) * h (first_ray rows first f).
Proof.
  intros f h Hf [Ah Zh]. destruct (hull_vertices rows first cells acc f Hf) as [_ [L _]].
  assert (Lf := first_length rows first cells acc).
  assert (Pos : 0 < INR (length (vertices f))) by (apply lt_0_INR; lia).
  unfold mean. rewrite (affine_comb (fun x => h (from_o x))).
  - unfold first_ray. rewrite (linear_sum h) by (split; auto). set (k := / INR (length (vertices f))).
    generalize (vertices f). clear - acc. intro w. unfold real. induction w as [|p w IH]; simpl; [ring|].
    rewrite IH, from_o_sample. ring.
  - apply from_o_affine. auto.
  - rewrite repeat_length. unfold real. rewrite map_length. auto.
  - rewrite sum_repeat. field. lra.
Qed.
Lemma mean_in_cell : forall k c i, nth_error cells k = Some c -> (i < length c)%nat -> In (facet_at k c i) hull ->
  in_conv P (mean (facet_at k c i)) /\ in_conv (real rows (vertices (facet_at k c i))) (mean (facet_at k c i)) /\
  forall v, In v (real rows c) -> 0 <= b (real rows c) v (mean (facet_at k c i)).
Proof.
  intros k c i Hk B Hf. set (f := facet_at k c i) in *. assert (Hc : In c cells) by (eapply nth_error_In; eauto).
  destruct (hull_vertices rows first cells acc f Hf) as [_ [L Nv]].
  assert (Lf := first_length rows first cells acc).
  assert (Pos : 0 < / INR (length (vertices f))) by (apply Rinv_0_lt_compat, lt_0_INR; lia).
  assert (Own : in_conv (real rows (vertices f)) (mean f)).
  { exists (repeat (/ INR (length (vertices f))) (length (vertices f))). split; [|split; [|split]]; auto.
    - rewrite repeat_length. unfold real. rewrite map_length. auto.
    - apply Forall_repeat. lra.
    - rewrite sum_repeat. field. apply Rgt_not_eq, lt_0_INR. lia. }
  split.
  - apply (conv_incl (real rows (vertices f))); auto. intros v Hv. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]].
    apply (in_map (fun i => emb (place rows i))). auto.
  - split; auto. intros v Hv. assert (Hu : In (real rows c) real_cells) by (apply in_real_cells; eauto).
    apply (hull_nonneg (b (real rows c) v) (real rows (vertices f))); auto.
    + apply (coord_lin PL); auto.
    + intros w Hw. apply in_map_iff in Hw. destruct Hw as [p [<- Hp]]. change (vertices f) with (without i c) in Hp.
      apply (in_without rows first cells acc) in Hp; auto. destruct Hp as [Hp _].
      assert (Iw : In (emb (place rows p)) (real rows c)) by (apply (in_map (fun i => emb (place rows i))); auto).
      destruct (vec_eq_dec (emb (place rows p)) v) as [<-|D].
      * rewrite (coord_one PL) by auto. lra.
      * rewrite (coord_zero PL) by auto. lra.
Qed.

Theorem one_cell_alone : exists u o, In u real_cells /\ inside (in_conv P) b u o /\
  forall s, In s real_cells -> s <> u -> exists v, In v s /\ b s v o < 0.
Proof.
  destruct (ray_once rows first cells acc checked) as [f [Hf [_ [_ Far]]]].
  assert (Hf' := Hf). fold hull in Hf. destruct (hull_facet cells f Hf) as [k [c [i [Hk [Hc [B [Ef _]]]]]]].
  destruct (hull_vertices rows first cells acc f Hf) as [_ [L _]].
  assert (Lf := first_length rows first cells acc).
  set (q := / INR (length (vertices f))). assert (Pq : 0 < q) by (apply Rinv_0_lt_compat, lt_0_INR; lia).
  destruct (mean_in_cell k c i Hk B ltac:(rewrite <- Ef; auto)) as [Cm [Om Bm]]. rewrite <- Ef in Cm, Om, Bm.
  set (m0 := mean f) in *. set (z0 := mix 2 middle_point m0).
  assert (Hu : In (real rows c) real_cells) by (apply in_real_cells; eauto).
  assert (Lm : in_level m0).
  { apply (conv_level _ _ _ P); auto. apply (sample_level rows first cells acc). }
  assert (Lz : in_level z0) by (unfold z0; apply level_mix; [apply middle_level | exact Lm]).
  assert (Vz : forall h, linear h -> h (from_o z0) = 2 * q * h (first_ray rows first f)).
  { intros h Lh. unfold z0. rewrite (affine_mix (fun x => h (from_o x))) by (apply from_o_affine; apply Lh).
    rewrite from_o_middle, (proj2 Lh). unfold m0. rewrite (mean_value f h Hf Lh). fold q. ring. }
  assert (Vm : forall h, linear h -> h (from_o m0) = q * h (first_ray rows first f))
    by (intros h Lh; apply (mean_value f h Hf Lh)).
  (* what is negative at both ends *)
  set (tests := flat_map (fun g => map (fun v x => -1 * cone (rays g) v (from_o x)) (rays g)) hull).
  assert (At : forall h, In h tests -> affine h).
  { intros h Hh. apply in_flat_map in Hh. destruct Hh as [g [Hg Hh]]. apply in_map_iff in Hh.
      destruct Hh as [v [<- Hv]].
    apply affine_scale. apply (from_o_affine (cone (rays g) v)). apply (coord_lin FP); auto. apply in_fan; eauto. }
  assert (Ad : affine (fun x => depth (rays f) (from_o x)))
    by (apply from_o_affine; apply (depth_affine rows first cells checked); auto).
  assert (Dz : depth (rays f) (from_o z0) < 0).
  { unfold z0. rewrite (affine_mix (fun x => depth (rays f) (from_o x))) by auto. rewrite from_o_middle.
    assert (Dm : depth (rays f) vzero = 1) by (apply (depth_middle rows first cells checked); auto). rewrite Dm.
    assert (Zm : depth (rays f) (from_o m0) = 0).
    { apply (hull_equal (fun x => depth (rays f) (from_o x)) (fun _ => 0) (real rows (vertices f)));
        auto using affine_const.
      intros w Hw. apply in_map_iff in Hw. destruct Hw as [p [<- Hp]]. rewrite from_o_sample.
      apply (depth_ray rows first cells checked f); auto. apply (in_map (fun p => emb (toward rows first p))). auto. }
    rewrite Zm. lra. }
  destruct (all_near tests m0 At) as [e1 [He1 N1]]. destruct (all_near tests z0 At) as [e2 [He2 N2]].
  destruct (affine_near (fun x => -1 * depth (rays f) (from_o x)) z0) as [e3 [He3 N3]];
    [apply affine_scale; auto | lra |].
  set (e := Rmin e1 (Rmin e2 e3)).
  assert (He : 0 < e) by (unfold e; repeat apply Rmin_pos; auto).
  assert (Le : e <= e1 /\ e <= e2 /\ e <= e3).
  { unfold e. generalize (Rmin_l e1 (Rmin e2 e3)), (Rmin_r e1 (Rmin e2 e3)), (Rmin_l e2 e3), (Rmin_r e2 e3). lra. }
  set (J := fun x => in_conv P x /\ in_cell in_level b (real rows c) x).
  assert (MJ : movable (lin := affine) (P := P) J).
  { exists (real rows c). split; [|intros h Hh; apply (nonzero_at_vertex PL); auto].
    intros y v t Ht [Cy Iy] Hv. split.
    - apply hull_mix; auto. apply point_in_conv. apply (cell_points PL (real rows c)); auto.
    - apply (in_cell_mix PL); auto. apply (vertex_in_cell PL); auto. }
  destruct (generic_near PL in_level J z0 m0 e) as [z [y [Lz' [[Cy Iy] [Dz' [Dy G]]]]]]; auto.
  { eapply movable_space; eauto. }
  { split; auto. split; auto. }
  exists (real rows c), y. split; auto. split.
  { split; auto. apply (generic_inside (cells := real_cells) (K := in_level)); auto. apply G. }
  intros s Hs D. apply NNPP. intro None. apply D.
  assert (Is : in_cell in_level b s y).
  { split; [apply Iy|]. intros v Hv. apply Rnot_lt_le. intro N. apply None. eauto. }
  destruct (walk_ends PL marked pairs_marked y z s Hs G Lz' Is) as [a [t [Ht [R E]]]].
  assert (Et : t = real rows c).
  { destruct E as [E|E].
    - exfalso. generalize (N3 z ltac:(lra)).
      assert (0 <= depth (rays f) (from_o z)); [|lra].
      apply (beyond (fun x => depth (rays f) (from_o x)) 0 z t); auto.
      intros p Hp. apply samples_inside; auto.
    - destruct E as [v [a' [Ba [Hv [[k' [c' [i' [Hk' [B' [-> [-> Hg]]]]]]] [Iq [Zq _]]]]]]].
      destruct (facet_point k' c' i' _ Hk' B' Hg Iq Zq) as [[_ Cone] _].
      destruct (facet_eq (facet_at k' c' i') f) as [F|F].
      + rewrite Ef in F. injection F. intros. subst. reflexivity.
      + exfalso. destruct (Far _ Hg F) as [r [Hr Nr]].
        set (h := cone (rays (facet_at k' c' i')) r) in *.
        assert (Lh : linear h) by (apply (coord_lin FP); auto; apply in_fan; eauto).
        assert (T : In (fun x => -1 * h (from_o x)) tests).
        { apply in_flat_map. exists (facet_at k' c' i'). split; auto.
          apply (in_map (fun v x => -1 * cone (rays (facet_at k' c' i')) v (from_o x))). auto. }
        assert (Nr' : h (first_ray rows first f) < 0) by exact Nr.
        assert (Ny : h (from_o y) < 0).
        { assert (0 < -1 * h (from_o y)); [|lra]. apply (N1 _ y T); [|lra]. rewrite (Vm h Lh). nra. }
        assert (Nz : h (from_o z) < 0).
        { assert (0 < -1 * h (from_o z)); [|lra]. apply (N2 _ z T); [|lra]. rewrite (Vz h Lh). nra. }
        generalize (Cone r Hr). fold h. rewrite (affine_mix (fun x => h (from_o x))) by (apply from_o_affine; apply Lh).
        intro Q. assert (0 < (1 - a') * - h (from_o y)) by (apply Rmult_lt_0_compat; lra).
        assert (0 < a' * - h (from_o z)) by (apply Rmult_lt_0_compat; lra). lra. }
  subst t.
  apply (one_start PL marked pairs_marked y z s (real rows c) a (real rows c) Lz' Hs Hu
    (generic_inside (cells := real_cells) s y Hs (proj1 (proj2 G)) Is)
    (generic_inside (cells := real_cells) (real rows c) y Hu (proj1 (proj2 G)) Iy) R 0). apply starts.
Qed.

Theorem accepted_glued : glued_cells (in_conv P) real_cells b.
Proof.
  split; [|destruct one_cell_alone as [u [o [H1 [H2 H3]]]]; exists u, o; auto].
  destruct pairs_marked as [H1 H2 H3]. split; auto. intros u v Hu Hv.
  destruct (H3 u v Hu Hv) as [H|[k [c [i [Hk [B [-> [-> Hf]]]]]]]]; [left; auto|]. right.
  assert (Hc : In c cells) by (eapply nth_error_In; eauto).
  intros x Hx. apply (hull_nonneg _ P); auto; [apply (coord_lin PL); auto|].
  intros p Hp. destruct (sample_is_row rows p Hp) as [j [_ ->]].
  apply (sample_coordinate_sign rows first cells acc k c i); auto.
  apply Z.le_ngt. intro L. generalize (proj2 (depth_sample rows first cells acc checked _ j Hf) L).
  generalize (samples_inside _ _ Hf Hp). rewrite from_o_sample. fold depth rays. lra.
Qed.
End TilingSound.
