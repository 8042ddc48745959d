(* Cells tile the convex hull of the points: they cover it, and no two of them have an inner point in common (step 4 of
   the proof of FC-CERT-02), if each of their facets has either one cell on its other side, or all points on its inner
   side, and some inner point of one cell is in no other cell.
   The proof walks along a straight line from cell to cell, which meets no face of dimension d - 2. *)
From Coq Require Import Reals Lra Lia List Psatz Classical.
From Flowcert Require Import algebra.Vector3 spec.Hull checker.Affine.
Import ListNotations.
Open Scope R_scope.

(* The facet of u without v is the facet of u' without v'. *)
Definition across (u : list vec) (v : vec) (u' : list vec) (v' : vec) :=
  In v u /\ In v' u' /\ forall x, (In x u /\ x <> v) <-> (In x u' /\ x <> v').

(* b u v is the barycentric coordinate of v in the cell u. K is where that is asked, a convex set with the points P, and
   lin has the functions that are told by their values at the points of a cell. *)
Record proper_cells (K : vec -> Prop) (lin : (vec -> R) -> Prop) (P : list vec) (cells : list (list vec))
  (b : list vec -> vec -> vec -> R) : Prop := {
  lin_affine : forall h, lin h -> affine h;
  lin_scale : forall h k, lin h -> lin (fun x => k * h x);
  lin_minus : forall f h, lin f -> lin h -> lin (fun x => f x - h x);
  space_mix : forall a y x, 0 <= a <= 1 -> K y -> K x -> K (mix a y x);
  space_points : forall p, In p P -> K p;
  cell_nodup : forall u, In u cells -> NoDup u;
  cell_points : forall u, In u cells -> incl u P;
  coord_lin : forall u v, In u cells -> In v u -> lin (b u v);
  coord_one : forall u v, In u cells -> In v u -> b u v v = 1;
  coord_zero : forall u v w, In u cells -> In v u -> In w u -> w <> v -> b u v w = 0;
  expand : forall u h x, In u cells -> lin h -> K x -> h x = total u (fun v => b u v x * h v) }.

Definition in_cell (K : vec -> Prop) (b : list vec -> vec -> vec -> R) u x := K x /\ forall v, In v u -> 0 <= b u v x.
Definition inside (K : vec -> Prop) (b : list vec -> vec -> vec -> R) u x := K x /\ forall v, In v u -> 0 < b u v x.

(* Each facet has one cell on its other side, or is marked as one of the hull. *)
Record paired_cells (cells : list (list vec)) (b : list vec -> vec -> vec -> R) (hull : list vec -> vec -> Prop)
  : Prop := {
  other_side : forall u v u' v', In u cells -> In u' cells -> u <> u' -> across u v u' v' -> b u v v' < 0;
  one_behind : forall u v u1 v1 u2 v2, In u cells -> In u1 cells -> In u2 cells -> u <> u1 -> u <> u2 ->
    across u v u1 v1 -> across u v u2 v2 -> u1 = u2;
  paired_or_hull : forall u v, In u cells -> In v u ->
    (exists u' v', In u' cells /\ u <> u' /\ across u v u' v') \/ hull u v }.
Definition nothing_behind (K : vec -> Prop) (b : list vec -> vec -> vec -> R) u v := forall x, K x -> 0 <= b u v x.
Record glued_cells (K : vec -> Prop) (cells : list (list vec)) (b : list vec -> vec -> vec -> R) : Prop := {
  glued_pairs : paired_cells cells b (nothing_behind K b);
  covered_once : exists first o, In first cells /\ inside K b first o /\
    forall u, In u cells -> u <> first -> exists v, In v u /\ b u v o < 0 }.
Arguments lin_affine {K lin P cells b}. Arguments lin_scale {K lin P cells b}. Arguments lin_minus {K lin P cells b}.
Arguments space_mix {K lin P cells b}. Arguments space_points {K lin P cells b}.
Arguments cell_nodup {K lin P cells b}. Arguments cell_points {K lin P cells b}. Arguments coord_lin {K lin P cells b}.
Arguments coord_one {K lin P cells b}. Arguments coord_zero {K lin P cells b}. Arguments expand {K lin P cells b}.
Arguments other_side {cells b hull}. Arguments one_behind {cells b hull}. Arguments paired_or_hull {cells b hull}.
Arguments glued_pairs {K cells b}. Arguments covered_once {K cells b}.

Lemma across_sym : forall u v u' v', across u v u' v' -> across u' v' u v.
Proof. intros u v u' v' [A [B C]]. split; auto. split; auto. intro x. symmetry. apply C. Qed.

Section Tiling.
Context {K : vec -> Prop} {lin : (vec -> R) -> Prop} {P : list vec} {cells : list (list vec)}.
Context {b : list vec -> vec -> vec -> R}.
Hypothesis proper : proper_cells K lin P cells b.
Let nodup := cell_nodup proper.
Let points := cell_points proper.
Let b_lin := coord_lin proper.
Let b_one := coord_one proper.
Let b_zero := coord_zero proper.
Let expand := expand proper.

Let b_affine : forall u v, In u cells -> In v u -> affine (b u v) :=
  fun u v Hu Hv => lin_affine proper _ (b_lin u v Hu Hv).
Lemma cell_in_space : forall u v, In u cells -> In v u -> K v.
Proof. intros. apply (space_points proper). apply (points u); auto. Qed.
Lemma inside_in_cell : forall u x, inside K b u x -> in_cell K b u x.
Proof. intros u x [H1 H2]. split; auto. intros v Hv. apply H2 in Hv. lra. Qed.
Lemma vertex_in_cell : forall u v, In u cells -> In v u -> in_cell K b u v.
Proof.
  intros u v Hu Hv. split; [eapply cell_in_space; eauto|]. intros w Hw.
  destruct (vec_eq_dec v w) as [->|N]; [rewrite b_one; auto; lra | rewrite b_zero; auto; lra].
Qed.
Lemma in_cell_mix : forall u a y x, In u cells -> 0 <= a <= 1 -> in_cell K b u y -> in_cell K b u x ->
  in_cell K b u (mix a y x).
Proof.
  intros u a y x Hu Ha [Hy By] [Hx Bx]. split; [apply (space_mix proper); auto|]. intros v Hv.
  rewrite affine_mix by (apply b_affine; auto).
  generalize (Rmult_le_pos (1 - a) _ ltac:(lra) (By v Hv)), (Rmult_le_pos a _ ltac:(lra) (Bx v Hv)). lra.
Qed.

(* The coordinates of a cell, at what is behind its facet. *)
Lemma across_coordinate : forall u v u' v' x, In u cells -> In u' cells -> across u v u' v' -> K x ->
  b u v x = b u' v' x * b u v v'.
Proof.
  intros u v u' v' x Hu Hu' [Hv [Hv' A]] Hx. rewrite (expand u' (b u v) x) by auto.
  apply (total_one u' v' (fun w => b u' w x * b u v w)); auto.
  intros w Hw N. destruct (proj2 (A w)) as [I J]; auto. rewrite (b_zero u v w) by auto. ring.
Qed.
Lemma across_other : forall u v u' v' w x, In u cells -> In u' cells -> across u v u' v' -> K x ->
  b u v x = 0 -> b u v v' < 0 -> In w u -> w <> v -> b u w x = b u' w x.
Proof.
  intros u v u' v' w x Hu Hu' A Hx Z N Hw D.
  assert (Z' : b u' v' x = 0).
  { rewrite (across_coordinate u v u' v') in Z by auto. destruct (Rmult_integral _ _ Z); auto; lra. }
  rewrite (expand u' (b u w) x) by auto.
  destruct A as [Hv [Hv' A]]. destruct (proj1 (A w)) as [I J]; auto.
  rewrite (total_one u' w (fun y => b u' y x * b u w y)); auto.
  - rewrite (b_one u w) by auto. ring.
  - intros y Hy Ny. destruct (vec_eq_dec y v') as [->|Dy]; [rewrite Z'; ring|].
    destruct (proj2 (A y)) as [Iy Jy]; auto. rewrite (b_zero u w y) by auto. ring.
Qed.

(* ---- Points near a given one, on which finitely many affine functions are not 0 ---- *)

Definition somewhere_nonzero h := lin h /\ exists p, In p P /\ h p <> 0.

Lemma nonzero_at_vertex : forall u h, In u cells -> somewhere_nonzero h -> exists v, In v u /\ h v <> 0.
Proof.
  intros u h Hu [Ah [p [Hp Np]]]. apply NNPP. intro F. apply Np.
  rewrite (expand u h p) by (auto; apply (space_points proper); auto).
  apply total_zero. intros v Hv. destruct (Req_dec (h v) 0) as [->|N]; [ring|]. exfalso. eauto.
Qed.
(* A convex set that has points where such a function is not 0. *)
Definition movable (M : vec -> Prop) := exists V,
  (forall y v t, 0 <= t <= 1 -> M y -> In v V -> M (mix t y v)) /\
  (forall h, somewhere_nonzero h -> exists v, In v V /\ h v <> 0).
Lemma movable_cell : forall u, In u cells -> movable (in_cell K b u).
Proof.
  intros u Hu. exists u. split; [|intros h; apply nonzero_at_vertex; auto].
  intros y v t Ht Hy Hv. apply in_cell_mix; auto. apply vertex_in_cell; auto.
Qed.
Lemma movable_space : movable K.
Proof.
  exists P. split; [|intros h [_ H]; exact H].
  intros y v t Ht Hy Hv. apply (space_mix proper); auto. apply (space_points proper); auto.
Qed.
Lemma perturb : forall (M : vec -> Prop) x e hs, movable M -> M x -> 0 < e -> (forall h, In h hs ->
  somewhere_nonzero h) ->
  exists y, M y /\ dist2 y x < e /\ forall h, In h hs -> h y <> 0.
Proof.
  intros M x e hs [V [Mix Non]] Hx He. induction hs as [|h hs IH]; intro N.
  - exists x. split; auto. split; [|intros h []]. replace (dist2 x x) with 0; auto. vdestruct; vunfold; ring.
  - destruct IH as [y [Hy [Dy Ny]]]; [intros; apply N; right; auto|].
    destruct (Non h (N h (or_introl eq_refl))) as [v [Hv Nv]].
    destruct (Req_dec (h y) 0) as [Z|Z].
    + destruct (soon_some _ (soon_and _ _ (soon_near y v x e Dy)
        (soon_all _ hs (fun k t => k (mix t y v) <> 0)
          (fun k Hk => soon_nonzero k y v (lin_affine proper k (proj1 (N k (or_intror Hk)))) (Ny k Hk))))) as [t [Ht [D
            A]]].
      exists (mix t y v). split; [apply Mix; auto; lra|]. split; auto.
      intros k [<-|Hk]; [|apply A; auto].
      rewrite affine_mix by (apply (lin_affine proper); apply (N h (or_introl eq_refl))).
      rewrite Z. intro E. apply Nv. apply Rmult_eq_reg_l with t; lra.
    + exists y. split; auto. split; auto. intros k [<-|Hk]; auto.
Qed.

(* All coordinates of all cells. *)
Definition coordinates := flat_map (fun u => map (b u) u) cells.
Lemma in_coordinates : forall u v, In u cells -> In v u -> In (b u v) coordinates.
Proof. intros u v Hu Hv. unfold coordinates. apply in_flat_map. exists u. split; auto. apply in_map. auto. Qed.
Lemma coordinate_of : forall h, In h coordinates -> exists u v, In u cells /\ In v u /\ h = b u v.
Proof.
  intros h H. unfold coordinates in H. apply in_flat_map in H. destruct H as [u [Hu H]].
  apply in_map_iff in H. destruct H as [v [E Hv]]. eauto.
Qed.
Lemma coordinates_nonzero : forall h, In h coordinates -> somewhere_nonzero h.
Proof.
  intros h H. destruct (coordinate_of h H) as [u [v [Hu [Hv ->]]]]. split; [apply b_lin; auto|].
  exists v. split; [apply (points u); auto|]. rewrite b_one by auto. apply R1_neq_R0.
Qed.

(* Around a point, what is in a cell has the coordinates positive that are positive at the point. *)
Definition near_enough x e := 0 < e /\ forall u v z, In u cells -> In v u -> 0 < b u v x -> dist2 z x < e ->
  0 < b u v z.
Lemma near_enough_exists : forall x, exists e, near_enough x e.
Proof.
  intro x. destruct (all_near coordinates x) as [e [He H]].
  { intros h Hh. apply (lin_affine proper). apply coordinates_nonzero; auto. }
  exists e. split; auto. intros u v z Hu Hv. apply H. apply in_coordinates; auto.
Qed.
Lemma far_near : forall x, exists e, 0 < e /\
  forall u v z, In u cells -> In v u -> b u v x < 0 -> dist2 z x < e -> b u v z < 0.
Proof.
  intro x. destruct (all_near (map (fun h y => -1 * h y) coordinates) x) as [e [He H]].
  { intros h Hh. apply in_map_iff in Hh. destruct Hh as [k [<- Hk]]. apply affine_scale.
    apply (lin_affine proper). apply coordinates_nonzero; auto. }
  exists e. split; auto. intros u v z Hu Hv N D.
  assert (0 < -1 * b u v z) as Q; [|lra].
  apply (H (fun y => -1 * b u v y)); [|lra|exact D].
  apply (in_map (fun h y => -1 * h y)). apply in_coordinates; auto.
Qed.

(* ---- Generic segments ---- *)

Definition generic_point x := forall u v, In u cells -> In v u -> b u v x <> 0.
Definition generic y x := generic_point x /\ generic_point y /\
  forall u v w a, In u cells -> In v u -> In w u -> v <> w -> b u v (mix a y x) = 0 -> b u w (mix a y x) <> 0.

(* It vanishes at x, and on the face without v and w. *)
Definition through x u v w : vec -> R := fun y => b u v x * b u w y - b u w x * b u v y.
Definition all_through x : list (vec -> R) := flat_map (fun u => flat_map (fun v => flat_map (fun w =>
  if vec_eq_dec v w then [] else [through x u v w]) u) u) cells.

Lemma through_nonzero : forall x h, generic_point x -> In h (all_through x) -> somewhere_nonzero h.
Proof.
  intros x h G H. unfold all_through in H. apply in_flat_map in H. destruct H as [u [Hu H]].
  apply in_flat_map in H. destruct H as [v [Hv H]]. apply in_flat_map in H. destruct H as [w [Hw H]].
  destruct (vec_eq_dec v w) as [|N]; [destruct H|]. destruct H as [<-|[]]. split.
  - unfold through. apply (lin_minus proper); apply (lin_scale proper); apply b_lin; auto.
  - exists w. split; [apply (points u); auto|]. unfold through. rewrite b_one, (b_zero u v w) by auto.
    generalize (G u v Hu Hv). lra.
Qed.
Lemma generic_near : forall (M J : vec -> Prop) x y e, movable M -> movable J -> M x -> J y -> 0 < e ->
  exists x' y', M x' /\ J y' /\ dist2 x' x < e /\ dist2 y' y < e /\ generic y' x'.
Proof.
  intros M J x y e MM MJ Hx Hy He.
  destruct (perturb M x e coordinates MM Hx He coordinates_nonzero) as [x' [Hx' [Dx Nx]]].
  assert (Gx : generic_point x') by (intros u v Hu Hv; apply Nx; apply in_coordinates; auto).
  destruct (perturb J y e (coordinates ++ all_through x') MJ Hy He) as [y' [Hy' [Dy Ny]]].
  { intros h Hh. apply in_app_or in Hh. destruct Hh; [apply coordinates_nonzero | apply (through_nonzero x')]; auto. }
  exists x', y'. repeat split; auto.
  - intros u v Hu Hv. apply Ny. apply in_or_app. left. apply in_coordinates; auto.
  - intros u v w a Hu Hv Hw D Zv Zw. set (q := mix a y' x') in *.
    assert (T : through x' u v w y' <> 0).
    { apply Ny. apply in_or_app. right. apply in_flat_map. exists u. split; auto. apply in_flat_map. exists v.
      split; auto. apply in_flat_map. exists w. split; auto. destruct (vec_eq_dec v w); [contradiction | left; auto]. }
    assert (A : affine (through x' u v w)) by (apply affine_minus; apply affine_scale; apply b_affine; auto).
    assert (Eq : through x' u v w q = 0) by (unfold through; rewrite Zv, Zw; ring).
    assert (Ex : through x' u v w x' = 0) by (unfold through; ring).
    unfold q in Eq. rewrite affine_mix, Ex in Eq by auto.
    destruct (Rmult_integral (1 - a) (through x' u v w y')) as [E|E]; [lra | | auto].
    assert (a = 1) by lra. subst a. unfold q in Zv. rewrite mix_1 in Zv. apply (Gx u v); auto.
Qed.
Lemma generic_inside : forall u x, In u cells -> generic_point x -> in_cell K b u x -> inside K b u x.
Proof.
  intros u x Hu G [H N]. split; auto. intros v Hv. generalize (N v Hv), (G u v Hu Hv). lra.
Qed.

(* ---- The walk ---- *)

Variable hull : list vec -> vec -> Prop.
Hypothesis pairs : paired_cells cells b hull.

(* The walk along the segment from y to x leaves the cell u through the facet without v, and enters u'. *)
Definition crosses y x a u v u' v' :=
  let q := mix a y x in
  0 < a < 1 /\ across u v u' v' /\ u <> u' /\ in_cell K b u q /\ in_cell K b u' q /\
  b u v q = 0 /\ b u v x < 0 /\ b u' v' q = 0 /\ 0 < b u' v' x /\
  (forall w, In w u' -> w <> v' -> 0 < b u' w q).

(* The walk that starts in u0 is in u from the parameter a on. *)
Inductive reached (y x : vec) (u0 : list vec) : R -> list vec -> Prop :=
| starts : reached y x u0 0 u0
| enters : forall a a' u v u' v', reached y x u0 a u -> a < a' -> In u cells -> In u' cells ->
    crosses y x a' u v u' v' -> reached y x u0 a' u'.

(* Some of the segment behind a is in the cell. *)
Definition ahead y x a u := exists a', a < a' <= 1 /\ in_cell K b u (mix a' y x).

Lemma mix_between : forall h y x a a', affine h -> a <= a' <= 1 -> 0 <= h (mix a y x) -> 0 <= h x ->
  0 <= h (mix a' y x).
Proof.
  intros h y x a a' Ah Ha. rewrite !affine_mix by auto. intros H1 H2. destruct (Req_dec a 1) as [->|N].
  - assert (a' = 1) by lra. subst. lra.
  - assert (E : (1 - a') = (1 - a') / (1 - a) * (1 - a)) by (field; lra).
    assert (Kp : 0 <= (1 - a') / (1 - a)) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra]).
    assert (K1 : (1 - a') / (1 - a) <= 1).
    { apply Rmult_le_reg_r with (1 - a); [lra|]. rewrite <- E. lra. }
    set (k := (1 - a') / (1 - a)) in *.
    assert (0 <= k * ((1 - a) * h y + a * h x)) by (apply Rmult_le_pos; auto).
    assert (E2 : a' = 1 - k * (1 - a)) by lra. rewrite E, E2.
    assert (0 <= (1 - k) * h x) by (apply Rmult_le_pos; lra). lra.
Qed.

(* The first facet through which the segment leaves a cell. *)
Lemma first_exit : forall (hs : list vec) (h : vec -> vec -> R) y x a1,
  (forall v, In v hs -> affine (h v)) -> a1 <= 1 -> (forall v, In v hs -> 0 <= h v (mix a1 y x)) ->
  (forall v, In v hs -> 0 <= h v x) \/
  exists v a, In v hs /\ a1 <= a < 1 /\ h v (mix a y x) = 0 /\ h v x < 0 /\
              forall w, In w hs -> 0 <= h w (mix a y x).
Proof.
  intros hs h y x a1. induction hs as [|v hs IH]; intros A Ha N; [left; intros v []|].
  assert (Av : affine (h v)) by (apply A; left; auto).
  assert (Nv : 0 <= h v (mix a1 y x)) by (apply N; left; auto).
  (* where this one would be the exit *)
  assert (Own : h v x < 0 -> exists a, a1 <= a < 1 /\ h v (mix a y x) = 0).
  { intro Hx. rewrite affine_mix in Nv by auto. assert (Hy : 0 <= h v y \/ h v y < 0) by lra.
    assert (D : 0 < h v y - h v x).
    { destruct (Rlt_or_le 0 (h v y - h v x)); auto. exfalso. nra. }
    exists (h v y / (h v y - h v x)).
    assert (E : h v y / (h v y - h v x) * (h v y - h v x) = h v y) by (field; lra).
    set (r := h v y / (h v y - h v x)) in *. split; [split; nra|]. rewrite affine_mix by auto. nra. }
  destruct (IH (fun w Hw => A w (or_intror Hw)) Ha (fun w Hw =>
    N w (or_intror Hw))) as [All|[w [a [Hw [Ba [Zw [Xw All]]]]]]].
  - destruct (Rlt_or_le (h v x) 0) as [L|L].
    + right. destruct (Own L) as [a [Ba Z]]. exists v, a. repeat split; auto; try lra; [left; auto|].
      intros w [<-|Hw]; [lra|].
      apply (mix_between (h w) y x a1 a); auto; [apply A; right; auto | lra | apply N; right; auto].
    + left. intros w [<-|Hw]; auto.
  - right. destruct (Rlt_or_le (h v (mix a y x)) 0) as [L|L].
    + assert (Lx : h v x < 0).
      { destruct (Rlt_or_le (h v x) 0); auto. exfalso.
        generalize (mix_between (h v) y x a1 a Av ltac:(lra) Nv H). lra. }
      destruct (Own Lx) as [a' [Ba' Z']]. exists v, a'.
      assert (Lt : a' <= a).
      { destruct (Rle_or_lt a' a); auto. exfalso.
        rewrite affine_mix in Z', L by auto. assert (0 < h v y - h v x) by nra. nra. }
      repeat split; auto; try lra; [left; auto|]. intros k [<-|Hk]; [lra|].
      assert (Ak : affine (h k)) by (apply A; right; auto).
      assert (Nk : 0 <= h k (mix a1 y x)) by (apply N; right; auto).
      destruct (Rlt_or_le (h k x) 0) as [Lk|Lk]; [|apply (mix_between (h k) y x a1 a'); auto; lra].
      generalize (All k Hk). rewrite !affine_mix in * by auto. intro G.
      assert (0 < h k y - h k x).
      { destruct (Rlt_or_le 0 (h k y - h k x)); auto. exfalso. nra. }
      nra.
    + exists w, a. repeat split; auto; try lra; [right; auto|]. intros k [<-|Hk]; auto.
Qed.

(* It leaves the cell through a facet of the hull. *)
Definition exits y x u := exists v a, 0 < a < 1 /\ In v u /\ hull u v /\ in_cell K b u (mix a y x) /\
  b u v (mix a y x) = 0 /\ b u v x < 0.

Lemma enters_next : forall y x a u, K y -> K x -> 0 <= a -> generic y x -> In u cells ->
  in_cell K b u (mix a y x) -> ahead y x a u ->
  in_cell K b u x \/ exits y x u \/
  exists a' u' v v', a < a' /\ In u' cells /\ crosses y x a' u v u' v' /\ ahead y x a' u' /\ ~ ahead y x a' u.
Proof.
  intros y x a u Py Px Ha [Gx [Gy G]] Hu Hq [a1 [Ha1 [Hp Hq1]]].
  destruct (first_exit u (b u) y x a1) as [All|[v [a' [Hv [Ba [Z [X All]]]]]]]; auto; try lra.
  { left. split; auto. }
  right. set (q := mix a' y x) in *.
  assert (Pq : K q) by (apply (space_mix proper); auto; lra).
  destruct (paired_or_hull pairs u v Hu Hv) as [[u' [v' [Hu' [Nu A]]]]|Hull].
  2: { left. exists v, a'. repeat split; auto; lra. }
  right.
  assert (N : b u v v' < 0) by (apply (other_side pairs u v u' v'); auto).
  assert (Z' : b u' v' q = 0).
  { rewrite (across_coordinate u v u' v') in Z by auto. destruct (Rmult_integral _ _ Z); auto; lra. }
  assert (X' : 0 < b u' v' x).
  { rewrite (across_coordinate u v u' v') in X by auto. nra. }
  assert (Pos : forall w, In w u' -> w <> v' -> 0 < b u' w q).
  { intros w Hw D. destruct A as [Av [Av' A]]. destruct (proj2 (A w)) as [I J]; auto.
    rewrite <- (across_other u v u' v' w q); auto; [|split; auto].
    generalize (All w I), (G u v w a' Hu Hv I (fun E => J (eq_sym E)) Z). fold q. lra. }
  exists a', u', v, v'. split; [lra|]. split; auto. split; [|split].
  - refine (conj (conj _ _) (conj A (conj Nu (conj (conj Pq All) (conj (conj Pq _)
      (conj Z (conj X (conj Z' (conj X' Pos))))))))); try lra.
    intros w Hw. fold q. destruct (vec_eq_dec w v') as [->|D]; [lra|]. generalize (Pos w Hw D). lra.
  - destruct (soon_some (fun t => forall w, In w u' -> 0 <= b u' w (mix t q x))) as [t [Ht Q]].
    { apply (soon_all _ u' (fun w t => 0 <= b u' w (mix t q x))). intros w Hw.
      destruct (vec_eq_dec w v') as [->|D].
      - exists 1. split; [lra|]. intros t Ht. rewrite affine_mix, Z' by auto. nra.
      - destruct (soon_positive (b u' w) q x) as [e [He Hs]]; auto. exists e. split; auto.
        intros t Ht. generalize (Hs t Ht). lra. }
    exists (a' + t * (1 - a')). split; [split; nra|]. unfold q in Q. rewrite mix_mix in Q. split; auto.
    apply (space_mix proper); auto. split; nra.
  - intros [a2 [Ha2 [_ Neg]]]. generalize (Neg v Hv). unfold q in Z. rewrite affine_mix in * by auto.
    intro Ne. assert (0 < b u v y - b u v x) by nra. nra.
Qed.

Lemma cell_eq_dec : forall u v : list vec, {u = v} + {u <> v}.
Proof. apply list_eq_dec. apply vec_eq_dec. Qed.

Lemma walk_from : forall y x u0, K y -> K x -> generic y x ->
  forall n L a u, (length L <= n)%nat -> (forall u', In u' cells -> ahead y x a u' -> In u' L) ->
  0 <= a -> In u cells -> in_cell K b u (mix a y x) -> ahead y x a u -> reached y x u0 a u ->
  exists a' s, In s cells /\ reached y x u0 a' s /\ (in_cell K b s x \/ exits y x s).
Proof.
  intros y x u0 Py Px G. induction n as [|n IH]; intros L a u Ln HL Ha Hu Hq Hahead R.
  - generalize (HL u Hu Hahead). destruct L; [intros [] | simpl in Ln; lia].
  - destruct (enters_next y x a u Py Px Ha G Hu Hq Hahead) as [X|[X|[a' [u' [v [v' [La [Hu' [C [Ah Nah]]]]]]]]]].
    + exists a, u. auto.
    + exists a, u. auto.
    + apply (IH (remove cell_eq_dec u L) a' u'); auto; try lra.
      * generalize (remove_length_lt cell_eq_dec L u (HL u Hu Hahead)). lia.
      * intros k Hk Hk2. apply in_in_remove; [intros ->; auto|]. apply HL; auto.
        destruct Hk2 as [a2 [B2 I2]]. exists a2. split; auto; lra.
      * apply C.
      * eapply enters; eauto.
Qed.
Lemma walk_ends : forall y x t, In t cells -> generic y x -> K x -> in_cell K b t y ->
  exists a s, In s cells /\ reached y x t a s /\ (in_cell K b s x \/ exits y x s).
Proof.
  intros y x t Ht G Px Hy.
  assert (Iy : inside K b t y) by (apply generic_inside; auto; apply G).
  apply (walk_from y x t (proj1 Hy) Px G (length cells) cells 0 t); auto; try lra.
  - rewrite mix_0. auto.
  - destruct (soon_some (fun e => forall v, In v t -> 0 <= b t v (mix e y x))) as [e [He Q]].
    { apply (soon_all _ t (fun v e => 0 <= b t v (mix e y x))). intros v Hv.
      destruct (soon_positive (b t v) y x) as [e [He Hs]]; [apply b_affine; auto | apply Iy; auto |].
      exists e. split; auto. intros r Hr. generalize (Hs r Hr). lra. }
    exists e. split; [lra|]. split; auto. apply (space_mix proper); auto; [lra | apply Hy].
  - apply starts.
Qed.

(* ---- Two walks that end in one cell began in one cell ---- *)

Lemma not_entered : forall y x a u v s w, In u cells -> In s cells -> inside K b s y -> K x ->
  ~ crosses y x a u v s w.
Proof.
  intros y x a u v s w Hu Hs [Py Iy] Px [Ba [[_ [Hw _]] [_ [_ [_ [_ [_ [Z [X _]]]]]]]]].
  rewrite affine_mix in Z by (apply b_affine; auto). generalize (Iy w Hw). intro. nra.
Qed.
Lemma entered_from_one : forall y x a u v a' u' v' s w w',
  In u cells -> In u' cells -> In s cells -> K y -> K x ->
  crosses y x a u v s w -> crosses y x a' u' v' s w' -> a = a' /\ u = u'.
Proof.
  intros y x a u v a' u' v' s w w' Hu Hu' Hs Py Px C C'.
  assert (Later : forall a u v a' u' v' w w', In u cells -> In u' cells ->
    crosses y x a u v s w -> crosses y x a' u' v' s w' -> a < a' -> False).
  { clear - b_affine Hs. intros a u v a' u' v' w w' Hu Hu' C C' L.
    destruct C as [Ba [_ [_ [_ [[_ I] _]]]]].
    destruct C' as [Ba' [[_ [Hw _]] [_ [_ [_ [_ [_ [Z [X _]]]]]]]]].
    generalize (I w' Hw). rewrite affine_mix in * by (apply b_affine; auto). intro. nra. }
  assert (E : a = a').
  { destruct (Rtotal_order a a') as [L|[E|L]]; auto; exfalso; eauto. }
  split; auto. subst a'.
  assert (Ew : w = w').
  { destruct (vec_eq_dec w w') as [|D]; auto. exfalso.
    destruct C as [_ [_ [_ [_ [_ [_ [_ [_ [_ Pos]]]]]]]]].
    destruct C' as [_ [[_ [Hw' _]] [_ [_ [_ [_ [_ [Z' _]]]]]]]].
    generalize (Pos w' Hw' (fun E => D (eq_sym E))). lra. }
  subst w'.
  destruct C as [_ [A [N _]]]. destruct C' as [_ [A' [N' _]]].
  apply (one_behind pairs s w u v u' v'); auto using across_sym.
Qed.

Lemma one_start : forall y x u1 u2 a s, K x -> In u1 cells -> In u2 cells ->
  inside K b u1 y -> inside K b u2 y -> reached y x u1 a s -> forall a', reached y x u2 a' s -> u1 = u2.
Proof.
  intros y x u1 u2 a s Px H1 H2 I1 I2 R. induction R as [|a a1 u v s v' R IH La Hu Hs C]; intros a' R'.
  - inversion R' as [E1 E2|a0 a2 u v s v' R0 L0 Hu Hs C E1 E2]; subst; auto.
    exfalso. apply (not_entered y x a' u v u1 v'); auto.
  - inversion R' as [E1 E2|a0 a2 u' w s' w' R0 L0 Hu' Hs' C' E1 E2]; subst; auto.
    + exfalso. apply (not_entered y x a1 u v s v'); auto.
    + destruct (entered_from_one y x a1 u v a' u' w s v' w') as [_ E]; auto; [apply I1|].
      subst u'. apply (IH a0). auto.
Qed.

(* ---- A function for each cell, which does not fall where a facet is crossed ---- *)

Definition rises (F : list vec -> vec -> R) := (forall u u', In u cells -> In u' cells -> lin (fun x =>
  F u x - F u' x)) /\
  forall u v u' v', In u cells -> In u' cells -> u <> u' -> across u v u' v' ->
    (forall w, In w u' -> w <> v' -> F u w = F u' w) /\ F u' v' <= F u v'.

(* Along the walk from y to x, the function of the cell where it is does not exceed that of the first one. *)
Lemma walk_lowers : forall F y x t a u, rises F -> In t cells -> K y -> K x -> reached y x t a u ->
  In u cells /\ 0 <= a <= 1 /\ forall a', a <= a' <= 1 -> F u (mix a' y x) <= F t (mix a' y x).
Proof.
  intros F y x t a u [FL FC] Ht Py Px R. induction R as [|a a1 u v u' v' R [Hu [Ba IH]] La _ Hu' C].
  - split; auto. split; [lra|]. intros. lra.
  - destruct C as [Ba1 [A [Nu [_ [[_ Iu'] [_ [_ [Z' [X' _]]]]]]]]].
    split; auto. split; [lra|]. intros a' Ha. generalize (IH a' ltac:(lra)). intro Le.
    assert (0 <= F u (mix a' y x) - F u' (mix a' y x)); [|lra].
    assert (Pq : K (mix a' y x)) by (apply (space_mix proper); auto; lra).
    destruct (FC u v u' v' Hu Hu' Nu A) as [Zero Up].
    rewrite (expand u' (fun x => F u x - F u' x)) by auto.
    destruct A as [Hv [Hv' A]].
    rewrite (total_one u' v'); auto.
    + apply Rmult_le_pos; [apply (mix_between (b u' v') y x a1); auto; lra | lra].
    + intros w Hw D. rewrite (Zero w Hw D). ring.
Qed.
End Tiling.

(* ---- The tiling ---- *)

Section Glued.
Context {K : vec -> Prop} {lin : (vec -> R) -> Prop} {P : list vec} {cells : list (list vec)}.
Context {b : list vec -> vec -> vec -> R}.
Hypothesis proper : proper_cells K lin P cells b.
Hypothesis glued : glued_cells K cells b.
Let pairs := glued_pairs glued.
Let reached := reached (K := K) (cells := cells) (b := b).

Lemma walk : forall y x t, In t cells -> generic (cells := cells) (b := b) y x -> K x -> in_cell K b t y ->
  exists a s, In s cells /\ reached y x t a s /\ in_cell K b s x.
Proof.
  intros y x t Ht G Px Hy. destruct (walk_ends proper _ pairs y x t Ht G Px Hy) as [a [s [Hs [R [E|E]]]]]; [eauto|].
  exfalso. destruct E as [v [a' [_ [_ [Out [_ [_ N]]]]]]]. generalize (Out x Px). lra.
Qed.

Theorem cells_disjoint : forall u1 u2 x, In u1 cells -> In u2 cells -> inside K b u1 x -> in_cell K b u2 x -> u1 = u2.
Proof.
  intros u1 u2 x H1 H2 I1 I2.
  destruct (covered_once glued) as [first [o [Hf [Io Far]]]].
  destruct (near_enough_exists proper x) as [e1 [He1 N1]]. destruct (far_near proper o) as [e2 [He2 N2]].
  destruct (generic_near proper (in_cell K b first) (in_cell K b u2) o x (Rmin e1 e2)) as [o' [x' [Io' [Ix' [Do [Dx
    G]]]]]];
    auto using inside_in_cell; try (eapply movable_cell; eauto).
  { apply Rmin_pos; auto. }
  generalize (Rmin_l e1 e2), (Rmin_r e1 e2). intros M1 M2.
  assert (J2 : inside K b u2 x') by (apply (generic_inside (cells := cells)); auto; apply G).
  assert (J1 : inside K b u1 x').
  { split; [apply Ix'|]. intros v Hv. apply (N1 u1 v x'); auto; [apply I1; auto | lra]. }
  assert (End : forall u, In u cells -> inside K b u x' -> exists a, reached x' o' u a first).
  { intros u Hu J. destruct (walk x' o' u Hu G (proj1 Io') (inside_in_cell _ _ J)) as [a [s [Hs [R [_ KK]]]]].
    exists a. destruct (cell_eq_dec s first) as [->|D]; auto. exfalso.
    destruct (Far s Hs D) as [v [Hv Nv]]. generalize (KK v Hv), (N2 s v o' Hs Hv Nv). intros K1 K2.
    assert (b s v o' < 0) by (apply K2; lra). lra. }
  destruct (End u1 H1 J1) as [a R]. destruct (End u2 H2 J2) as [a' R'].
  apply (one_start proper _ pairs x' o' u1 u2 a first (proj1 Io') H1 H2 J1 J2 R a' R').
Qed.

Theorem cells_cover : forall x, K x -> exists u, In u cells /\ in_cell K b u x.
Proof.
  intros x Hx. destruct (far_near proper x) as [e [He N]].
  destruct (covered_once glued) as [first [o [Hf [Io _]]]].
  destruct (generic_near proper (K) (in_cell K b first) x o e) as [x' [o' [Px' [Io' [Dx [_ G]]]]]];
    auto using inside_in_cell; try (eapply movable_cell; eauto); try (eapply movable_space; eauto).
  destruct (walk o' x' first Hf G Px' Io') as [a [s [Hs [_ [_ KK]]]]].
  exists s. split; auto. split; auto. intros v Hv. apply Rnot_lt_le. intro L.
  generalize (KK v Hv), (N s v x' Hs Hv L Dx). lra.
Qed.

(* Such functions have their least value at a point for the cell that has it. *)
Theorem least_value : forall F s t x v, rises (lin := lin) (cells := cells) F -> In s cells -> In t cells -> In v t ->
  in_cell K b s x -> F s x <= F t x.
Proof.
  intros F s t x v HF Hs Ht Hv Hx. apply Rnot_lt_le. intro L.
  destruct (affine_near (fun y => F s y - F t y) x) as [e [He Near]];
    [apply (lin_affine proper); apply HF; auto | lra |].
  destruct (generic_near proper (in_cell K b s) (in_cell K b t) x v e) as [x' [y' [Ix [Iy [Dx [_ G]]]]]];
    auto; try (eapply movable_cell; eauto); [eapply vertex_in_cell; eauto|].
  destruct (walk y' x' t Ht G (proj1 Ix) Iy) as [a [s' [Hs' [R Ix']]]].
  assert (E : s = s').
  { apply (cells_disjoint s s' x'); auto. apply (generic_inside (cells := cells)); auto. apply G. }
  subst s'. destruct (walk_lowers proper F y' x' t a s HF Ht (proj1 Iy) (proj1 Ix) R) as [_ [Ba M]].
  generalize (M 1 ltac:(lra)), (Near x' Dx). rewrite mix_1. lra.
Qed.
End Glued.
