(* Steps 5 to 7 of the proof of FC-CERT-02: in a tiling whose neighbours are locally Delaunay, the sphere of the cell at
   a point is the one to which this point has the least power; no sample is inside the sphere of a cell; and cells meet
   face to face. *)
From Coq Require Import Reals Lra Lia List Psatz Classical.
From Flowcert Require Import algebra.Vector3 spec.Hull algebra.Sphere checker.Affine checker.Tiling.
Import ListNotations.
Open Scope R_scope.

(* T3 and T8. *)
Record local_delaunay (P : list vec) (cells : list (list vec)) : Prop := {
  has_sphere : forall u, In u cells -> exists z r2, on_sphere z r2 u;
  opposite_not_inside : forall u v u' v' z r2, In u cells -> In u' cells -> u <> u' -> across u v u' v' ->
    on_sphere z r2 u -> 0 <= power z r2 v';
  all_in_cells : forall p, In p P -> exists u, In u cells /\ In p u }.

Section Delaunay.
Variable P : list vec.
Variable cells : list (list vec).
Variable b : list vec -> vec -> vec -> R.
Hypothesis proper : proper_cells (in_conv P) affine P cells b.
Hypothesis glued : glued_cells (in_conv P) cells b.
Hypothesis local : local_delaunay P cells.
Let b_affine := coord_lin proper.
Let b_one := coord_one proper.
Let b_zero := coord_zero proper.

(* ---- 5: convexity ---- *)

Lemma same_power : forall u z r2 z' s2 x, In u cells -> in_conv P x -> on_sphere z r2 u -> on_sphere z' s2 u ->
  power z r2 x = power z' s2 x.
Proof.
  intros u z r2 z' s2 x Hu Hx S S'.
  assert (power z r2 x - power z' s2 x = 0); [|lra].
  rewrite (expand proper u (fun x => power z r2 x - power z' s2 x)) by (auto using power_difference).
  apply total_zero. intros v Hv. rewrite S, S' by auto. ring.
Qed.

Lemma choose_spheres : exists centre : list vec -> vec * R,
  forall u, In u cells -> on_sphere (fst (centre u)) (snd (centre u)) u.
Proof.
  assert (G : forall l, incl l cells -> exists centre : list vec -> vec * R,
    forall u, In u l -> on_sphere (fst (centre u)) (snd (centre u)) u).
  { induction l as [|t l IH]; intro I; [exists (fun _ => (vzero, 0)); intros u []|].
    destruct IH as [f Hf]; [intros u Hu; apply I; right; auto|].
    destruct (has_sphere _ _ local t (I t (or_introl eq_refl))) as [z [r2 S]].
    exists (fun u => if cell_eq_dec u t then (z, r2) else f u). intros u Hu.
    destruct (cell_eq_dec u t) as [->|D]; auto. destruct Hu as [->|Hu]; [contradiction | auto]. }
  apply G. intros u Hu. auto.
Qed.

Lemma cell_has_vertex : forall u x, In u cells -> in_conv P x -> exists v, In v u.
Proof.
  intros u x Hu Hx. destruct u as [|v u]; [|exists v; left; auto]. exfalso.
  assert (1 = total [] (fun v => b [] v x * 1)) as E; [|unfold total in E; simpl in E; lra].
  apply (expand proper [] (fun _ => 1) x); auto. apply affine_const.
Qed.

Theorem least_power : forall s t z r2 z' s2 x, In s cells -> In t cells -> in_cell (in_conv P) b s x ->
  on_sphere z r2 s -> on_sphere z' s2 t -> power z r2 x <= power z' s2 x.
Proof.
  intros s t z r2 z' s2 x Hs Ht Hx S S'. destruct choose_spheres as [f Hf].
  rewrite (same_power s z r2 (fst (f s)) (snd (f s))), (same_power t z' s2 (fst (f t)) (snd (f t))) by (auto; apply Hx).
  destruct (cell_has_vertex t x Ht (proj1 Hx)) as [v Hv].
  apply (least_value proper glued (fun u => power (fst (f u)) (snd (f u))) s t x v); auto. split.
  - intros. apply power_difference.
  - intros u w u' w' Hu Hu' D A. split.
    + intros y Hy Ny. destruct A as [_ [_ A]]. destruct (proj2 (A y)) as [Iy _]; auto.
      rewrite (Hf u Hu y), (Hf u' Hu' y) by auto. auto.
    + rewrite (Hf u' Hu' w' (proj1 (proj2 A))). apply (opposite_not_inside _ _ local u w u' w'); auto.
Qed.

(* ---- 6: empty spheres ---- *)

Theorem empty_spheres : forall t z r2 p, In t cells -> In p P -> on_sphere z r2 t -> 0 <= power z r2 p.
Proof.
  intros t z r2 p Ht Hp S. destruct (all_in_cells _ _ local p Hp) as [u [Hu Iu]].
  destruct (has_sphere _ _ local u Hu) as [zu [ru Su]]. rewrite <- (Su p Iu).
  apply (least_power u t); auto. eapply vertex_in_cell; eauto.
Qed.

(* ---- 7: face to face ---- *)

Theorem sample_in_cell : forall t p, In t cells -> In p P -> in_cell (in_conv P) b t p -> In p t.
Proof.
  intros t p Ht Hp [Pp Ip]. destruct (has_sphere _ _ local t Ht) as [z [r2 S]].
  generalize (empty_spheres t z r2 p Ht Hp S). intro E.
  assert (Ex : power z r2 p - power p 0 p = total t (fun v => b t v p * (power z r2 v - power p 0 v)))
    by (apply (expand proper t (fun x => power z r2 x - power p 0 x)); auto using power_difference).
  assert (Zero : forall v, In v t -> b t v p * dist2 p v = 0).
  { apply total_nonneg_zero.
    - intros v Hv. apply Rmult_le_pos; auto. apply dot_self_nonneg.
    - assert (Eq : total t (fun v => b t v p * (power z r2 v - power p 0 v)) = - 1 * total t (fun v =>
        b t v p * dist2 p v)).
      { rewrite <- total_scale. apply total_ext. intros v Hv. rewrite (S v) by auto. unfold power. ring. }
      assert (0 <= total t (fun v => b t v p * dist2 p v)).
      { apply total_nonneg. intros v Hv. apply Rmult_le_pos; auto. apply dot_self_nonneg. }
      rewrite Eq in Ex. unfold power at 2 in Ex. rewrite dist2_refl in Ex. lra. }
  apply NNPP. intro N.
  assert (One : 1 = total t (fun v => b t v p * 1)) by (apply (expand proper t (fun _ => 1)); auto using affine_const).
  rewrite total_zero in One; [lra|]. intros v Hv. destruct (Rmult_integral _ _ (Zero v Hv)) as [->|D]; [ring|].
  apply dist2_zero in D. subst. contradiction.
Qed.

(* The coordinates of a point of one cell, in another cell that has all of its vertices with positive weight. *)
Lemma support_coordinate : forall t u x w, In t cells -> In u cells -> in_cell (in_conv P) b t x ->
  (forall v, In v t -> 0 < b t v x -> In v u) -> In w u ->
  (In w t -> b u w x = b t w x) /\ (~ In w t -> b u w x = 0).
Proof.
  intros t u x w Ht Hu [Px Ix] Sub Hw.
  assert (Ex : b u w x = total t (fun v => b t v x * b u w v)) by (apply (expand proper t (b u w)); auto).
  assert (Zero : forall v, In v t -> v <> w -> b t v x * b u w v = 0).
  { intros v Hv D. destruct (Rle_lt_or_eq_dec 0 (b t v x) (Ix v Hv)) as [Pos|<-]; [|ring].
    rewrite (b_zero u w v); auto. ring. }
  split; intro I.
  - rewrite Ex, (total_one t w); auto; [rewrite b_one by auto; ring|]. apply (cell_nodup proper); auto.
  - rewrite Ex. apply total_zero. intros v Hv. apply Zero; auto. congruence.
Qed.

Lemma walk_keeps : forall x0 e y x t a u, near_enough (cells := cells) (b := b) x0 e -> In t cells ->
  in_cell (in_conv P) b t x0 ->
  dist2 y x0 < e -> dist2 x x0 < e -> reached (K := in_conv P) (cells := cells) (b := b) y x t a u ->
  In u cells /\ forall v, In v t -> 0 < b t v x0 -> In v u.
Proof.
  intros x0 e y x t a u [He Near] Ht I Dy Dx R. induction R as [|a a1 u v u' v' R [Hu Sub] La _ Hu' C].
  - split; auto.
  - split; auto. intros w Hw Pos. destruct C as [Ba [[Hv [Hv' A]] [_ [_ [_ [Z _]]]]]].
    apply A. split; [auto|]. intros ->.
    destruct (support_coordinate t u x0 v Ht Hu I Sub Hv) as [E _].
    assert (Q : 0 < b u v (mix a1 y x)); [|lra].
    apply Near; auto; [rewrite E; auto|]. apply dist2_mix; auto; lra.
Qed.

Theorem face_to_face : forall t s x v, In t cells -> In s cells -> in_cell (in_conv P) b t x ->
  in_cell (in_conv P) b s x ->
  In v t -> 0 < b t v x -> In v s.
Proof.
  intros t s x v Ht Hs It Is Hv Pos. destruct (near_enough_exists proper x) as [e Near].
  destruct (generic_near proper (in_cell (in_conv P) b s) (in_cell (in_conv P) b t) x x e) as [x' [y' [Ix [Iy [Dx [Dy
    G]]]]]];
    auto; try (eapply movable_cell; eauto); [apply Near|].
  destruct (walk proper glued y' x' t Ht G (proj1 Ix) Iy) as [a [s' [Hs' [R Ix']]]].
  assert (E : s = s').
  { apply (cells_disjoint proper glued s s' x'); auto. apply (generic_inside (cells := cells)); auto; apply G. }
  subst s'. apply (walk_keeps x e y' x' t a s); auto.
Qed.
End Delaunay.
