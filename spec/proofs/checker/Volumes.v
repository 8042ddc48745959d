(* Barycentric coordinates in cells of dimension 1, 2 and 3, as quotients of volumes.
   n tells volumes in dimension 1 and 2, as in the checker: the edge or the normal of the first cell. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull checker.Affine.
Import ListNotations.
Open Scope R_scope.

Definition volume_of (n : vec) (v : list vec) : R :=
  match v with
  | [a] => dot a n
  | [a; b] => dot (cross a b) n
  | [a; b; c] => det a b c
  | _ => 0
  end.
Definition edges_of (s : list vec) : list vec :=
  match s with [] => [] | o :: s' => map (fun p => vsub p o) s' end.
Definition cell_volume n s := volume_of n (edges_of s).

(* The cell with x in the place of v. *)
Definition swap_in (v x w : vec) := if vec_eq_dec w v then x else w.
Definition coordinate (n : vec) (u : list vec) (v x : vec) : R := cell_volume n (map (swap_in v x) u) / cell_volume n u.

(* The affine hull of the first cell: p is in it. n is the edge, or the normal; o is a point of it. *)
Definition level (d : nat) (n o p : vec) : Prop :=
  match d with 1%nat => cross n (vsub p o) = vzero | 2%nat => dot n (vsub p o) = 0 | _ => True end.

Lemma map_swap : forall l1 v l2 x, NoDup (l1 ++ v :: l2) -> map (swap_in v x) (l1 ++ v :: l2) = l1 ++ x :: l2.
Proof.
  intros l1 v l2 x N. apply NoDup_remove in N. destruct N as [_ N].
  assert (G : forall l, ~ In v l -> map (swap_in v x) l = l).
  { induction l as [|w l IH]; simpl; intro F; auto. rewrite IH by tauto. f_equal. unfold swap_in.
    destruct (vec_eq_dec w v); auto. exfalso. apply F. auto. }
  rewrite map_app. simpl. rewrite !G by (intro F; apply N; apply in_or_app; auto).
  unfold swap_in. destruct (vec_eq_dec v v); [auto | contradiction].
Qed.

Lemma affine_plane : forall h g p, (forall x, h x = dot g (vsub x p)) -> affine h.
Proof. intros h g p H. exists g, (- dot g p). intro x. rewrite H. vdestruct; vunfold; ring. Qed.

Ltac volumes := unfold cell_volume, volume_of, edges_of, det, dot, cross, vsub, vzero in *; simpl in *.

Lemma long_volume : forall n s, (5 <= length s)%nat -> cell_volume n s = 0.
Proof. intros n [|o [|a [|b [|c [|d s]]]]] L; simpl in L; try lia. reflexivity. Qed.

Lemma volume_affine : forall n l1 l2, affine (fun x => cell_volume n (l1 ++ x :: l2)).
Proof.
  intros n l1 l2. destruct (le_lt_dec 4 (length l1 + length l2)) as [L|L].
  - destruct (affine_const 0) as [g [c H]]. exists g, c. intro x. rewrite <- H. apply long_volume.
    rewrite app_length. simpl. lia.
  - destruct l1 as [|p [|q [|r [|s l1]]]]; destruct l2 as [|p' [|q' [|r' [|s' l2]]]]; simpl in L; try lia.
    + apply (affine_const 0).
    + apply (affine_plane _ (vscale (-1) n) p'). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross n (vsub q' p')) p'). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross (vsub r' p') (vsub q' p')) p'). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ n p). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross (vsub p' p) n) p). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross (vsub p' p) (vsub q' p)) p). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross n (vsub q p)) p). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross (vsub p' p) (vsub q p)) p). intro x. vdestruct; volumes; ring.
    + apply (affine_plane _ (cross (vsub q p) (vsub r p)) p). intro x. vdestruct; volumes; ring.
Qed.

(* A cell with two equal points has no volume. *)
Lemma volume_twice : forall n l1 x l2 l3, cell_volume n (l1 ++ x :: l2 ++ x :: l3) = 0.
Proof.
  intros n l1 x l2 l3. destruct (le_lt_dec 3 (length l1 + length l2 + length l3)) as [L|L].
  - apply long_volume. rewrite app_length. simpl. rewrite app_length. simpl. lia.
  - destruct l1 as [|p [|q [|r l1]]]; destruct l2 as [|p' [|q' [|r' l2]]]; destruct l3 as [|p'' [|q'' [|r'' l3]]];
      simpl in L; try lia; vdestruct; volumes; ring.
Qed.
Lemma volume_nodup : forall n u, cell_volume n u <> 0 -> NoDup u.
Proof.
  intros n u H.
  assert (G : NoDup u \/ exists l1 x l2 l3, u = l1 ++ x :: l2 ++ x :: l3).
  { clear H. induction u as [|x u IH]; [left; constructor|].
    destruct (in_dec vec_eq_dec x u) as [I|I].
    - right. apply in_split in I. destruct I as [l2 [l3 ->]]. exists [], x, l2, l3. reflexivity.
    - destruct IH as [N|[l1 [y [l2 [l3 ->]]]]]; [left; constructor; auto|].
      right. exists (x :: l1), y, l2, l3. reflexivity. }
  destruct G as [N|[l1 [x [l2 [l3 ->]]]]]; auto. exfalso. apply H. apply volume_twice.
Qed.
Lemma volume_twice_in : forall n l1 l2 w, In w (l1 ++ l2) -> cell_volume n (l1 ++ w :: l2) = 0.
Proof.
  intros n l1 l2 w H. destruct (in_app_or _ _ _ H) as [I|I]; apply in_split in I; destruct I as [k1 [k2 ->]].
  - rewrite <- app_assoc. simpl. apply volume_twice.
  - apply volume_twice.
Qed.

Lemma coordinate_split : forall n u v, cell_volume n u <> 0 -> In v u -> exists l1 l2, u = l1 ++ v :: l2 /\
  forall x, coordinate n u v x = cell_volume n (l1 ++ x :: l2) / cell_volume n u.
Proof.
  intros n u v positive Hv. generalize (volume_nodup n u positive). apply in_split in Hv. destruct Hv as [l1 [l2 E]].
  intro N. exists l1, l2. split; auto. intro x. unfold coordinate. rewrite E at 1. rewrite map_swap; auto. congruence.
Qed.
Lemma coordinate_affine : forall n u v, cell_volume n u <> 0 -> In v u -> affine (coordinate n u v).
Proof.
  intros n u v positive Hv. destruct (coordinate_split n u v positive Hv) as [l1 [l2 [_ E]]].
  destruct (volume_affine n l1 l2) as [g [c H]].
  exists (vscale (/ cell_volume n u) g), (c / cell_volume n u). intro x. rewrite E, H.
  unfold Rdiv. generalize (/ cell_volume n u). clear. intro k. vdestruct; vunfold; ring.
Qed.
Lemma coordinate_one : forall n u v, cell_volume n u <> 0 -> In v u -> coordinate n u v v = 1.
Proof.
  intros n u v positive Hv. destruct (coordinate_split n u v positive Hv) as [l1 [l2 [E H]]]. rewrite H, <- E. field.
    auto.
Qed.
Lemma coordinate_zero : forall n u v w, cell_volume n u <> 0 -> In v u -> In w u -> w <> v -> coordinate n u v w = 0.
Proof.
  intros n u v w positive Hv Hw D. destruct (coordinate_split n u v positive Hv) as [l1 [l2 [E H]]].
  assert (I : In w (l1 ++ l2)).
  { rewrite E in Hw. apply in_app_or in Hw. apply in_or_app. destruct Hw as [|[->|]]; auto. contradiction. }
  rewrite H, volume_twice_in by auto. unfold Rdiv. ring.
Qed.

Lemma flat_det : forall n a b v, dot n a = 0 -> dot n b = 0 -> dot n v = 0 -> n <> vzero -> det a b v = 0.
Proof.
  intros n a b v Ha Hb Hv N.
  assert (E : vscale (det a b v) n =
    vadd (vscale (dot n a) (cross b v)) (vadd (vscale (dot n b) (cross v a)) (vscale (dot n v) (cross a b)))).
  { clear. apply vec_eq; vdestruct; vunfold; ring. }
  rewrite Ha, Hb, Hv in E. destruct (Req_dec (det a b v) 0) as [|D]; auto. exfalso. apply N.
  clear Ha Hb Hv. set (k := det a b v) in *. clearbody k.
  destruct n as [x y z]. unfold vscale, vadd, vzero in E. simpl in E. injection E. intros Ez Ey Ex.
  apply vec_eq; simpl; apply Rmult_eq_reg_l with k; auto; lra.
Qed.
Lemma parallel : forall n v, n <> vzero -> cross n v = vzero -> exists k, v = vscale k n.
Proof.
  intros n v N H. assert (D : dot n n <> 0) by (intro F; apply N; apply dot_self_zero; auto).
  exists (dot n v / dot n n).
  assert (E : vscale (dot n n) v = vscale (dot n v) n).
  { assert (F : vsub (vscale (dot n n) v) (vscale (dot n v) n) = cross (cross n v) n).
    { clear. apply vec_eq; vdestruct; vunfold; ring. }
    rewrite H in F. assert (Z : cross vzero n = vzero) by (apply vec_eq; vunfold; ring). rewrite Z in F.
    revert F. generalize (vscale (dot n n) v), (vscale (dot n v) n). clear. intros [a1 a2 a3] [b1 b2 b3] F.
    unfold vsub, vzero in F. simpl in F. injection F. intros. apply vec_eq; simpl; lra. }
  assert (E' : vscale (/ dot n n) (vscale (dot n n) v) = vscale (/ dot n n) (vscale (dot n v) n)) by (rewrite E; auto).
  revert E' D. generalize (dot n n), (dot n v). clear. intros d k E' D. destruct v as [a1 a2 a3], n as [b1 b2 b3].
  unfold vscale in *. simpl in *. injection E'. intros E3 E2 E1.
  apply vec_eq; simpl; unfold Rdiv.
  - replace a1 with (/ d * (d * a1)) by (field; auto). rewrite E1. ring.
  - replace a2 with (/ d * (d * a2)) by (field; auto). rewrite E2. ring.
  - replace a3 with (/ d * (d * a3)) by (field; auto). rewrite E3. ring.
Qed.

Lemma expand_vectors : forall n u d o h x, cell_volume n u <> 0 -> length u = S d -> (forall v, In v u ->
  level d n o v) -> level d n o x ->
  affine h -> h x = total u (fun v => coordinate n u v x * h v).
Proof.
  intros n u d o h x positive L Hu Hx Ah.
  assert (Nz : d <> 3%nat -> n <> vzero).
  { intros Hd ->. apply positive. destruct u as [|p [|q [|r [|s [|t w]]]]]; simpl in L; try reflexivity; try lia;
      vdestruct; volumes; ring. }
  (* the volumes with x in place of each point *)
  assert (Terms : cell_volume n u * total u (fun v => coordinate n u v x * h v) =
                  total u (fun v => cell_volume n (map (swap_in v x) u) * h v)).
  { rewrite <- total_scale. apply total_ext. intros v _. unfold coordinate. field. auto. }
  apply Rmult_eq_reg_l with (cell_volume n u); auto. rewrite Terms. clear Terms.
  generalize (volume_nodup n u positive). intro N.
  assert (Swap : forall l1 v l2, u = l1 ++ v :: l2 -> map (swap_in v x) u = l1 ++ x :: l2).
  { intros l1 v l2 ->. apply map_swap. auto. }
  destruct Ah as [g [c H]]. unfold total. set (F := fun v => cell_volume n (map (swap_in v x) u) * h v).
  destruct u as [|p [|q u']]; simpl in L; try (exfalso; apply positive; reflexivity).
  destruct u' as [|r u'].
  { (* dimension 1 *)
    assert (d = 1%nat) by (simpl in L; lia). subst d. change (sum (map F [p; q])) with (F p + (F q + 0)). unfold F.
    rewrite (Swap [] p [q]), (Swap [p] q []) by reflexivity. rewrite !H.
    assert (Hp := Hu p (or_introl eq_refl)). assert (Hq := Hu q (or_intror (or_introl eq_refl))). simpl in Hp, Hq, Hx.
    destruct (parallel _ _ (Nz ltac:(lia)) Hp) as [kp Ep]. destruct (parallel _ _ (Nz ltac:(lia)) Hq) as [kq Eq].
    destruct (parallel _ _ (Nz ltac:(lia)) Hx) as [kx Ex].
    assert (Op : p = vadd o (vscale kp n)) by (rewrite <- Ep; apply vec_eq; vdestruct; vunfold; ring).
    assert (Oq : q = vadd o (vscale kq n)) by (rewrite <- Eq; apply vec_eq; vdestruct; vunfold; ring).
    assert (Ox : x = vadd o (vscale kx n)) by (rewrite <- Ex; apply vec_eq; vdestruct; vunfold; ring).
    rewrite Op, Oq, Ox. clear. vdestruct; volumes. ring. }
  destruct u' as [|s u'].
  { (* dimension 2 *)
    assert (d = 2%nat) by (simpl in L; lia). subst d. change (sum (map F [p; q; r])) with (F p + (F q + (F r + 0))).
      unfold F.
    rewrite (Swap [] p [q; r]), (Swap [p] q [r]), (Swap [p; q] r []) by reflexivity. rewrite !H.
    assert (Hp := Hu p (or_introl eq_refl)). assert (Hq := Hu q (or_intror (or_introl eq_refl))).
    assert (Hr := Hu r (or_intror (or_intror (or_introl eq_refl)))). simpl in Hp, Hq, Hr, Hx.
    assert (D : det (vsub q p) (vsub r p) (vsub x p) = 0).
    { apply flat_det with n; auto; revert Hp Hq Hr Hx; clear; intros; vdestruct; vunfold; lra. }
    apply Rminus_diag_uniq. transitivity (det (vsub q p) (vsub r p) (vsub x p) * dot g n); [|rewrite D; ring].
    clear. vdestruct; volumes. ring. }
  destruct u' as [|t u'].
  { (* dimension 3 *)
    change (sum (map F [p; q; r; s])) with (F p + (F q + (F r + (F s + 0)))). unfold F.
    rewrite (Swap [] p [q; r; s]), (Swap [p] q [r; s]), (Swap [p; q] r [s]), (Swap [p; q; r] s [])
      by reflexivity. rewrite !H.
    clear. vdestruct; volumes. ring. }
  exfalso. apply positive. reflexivity.
Qed.
