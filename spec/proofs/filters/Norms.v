(* Errors of vectors, in Euclidean norms: sharper than counting roundings, because a cross product is no longer than
   the product of the lengths. napprox e N a x: a stands for x, |x| <= N and |a - x| <= e N. *)
From Coq Require Import Reals Lra Psatz Lia.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 filters.Rounding filters.RoundedVectors.
Open Scope R_scope.

Lemma len_nonneg : forall x, 0 <= len x. Proof. intros; apply sqrt_pos. Qed.
Lemma len_sq : forall x, len x * len x = dot x x.
Proof. intros; apply sqrt_sqrt, dot_self_nonneg. Qed.
Lemma len_le : forall x k, 0 <= k -> dot x x <= k * k -> len x <= k.
Proof.
  intros x k Hk H. apply Rsqr_incr_0_var; auto. unfold Rsqr. rewrite len_sq. exact H.
Qed.
Lemma absdot_dot : forall x y, Rabs (dot x y) <= absdot x y.
Proof.
  intros. unfold dot, absdot. rewrite <- !Rabs_mult.
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_r, Rabs_triang.
Qed.
Lemma dot_len : forall x y, Rabs (dot x y) <= len x * len y.
Proof. intros. eapply Rle_trans; [apply absdot_dot | apply absdot_len]. Qed.
Lemma len_triangle : forall x y, len (vadd x y) <= len x + len y.
Proof.
  intros x y. generalize (len_nonneg x) (len_nonneg y) (dot_len x y) (len_sq x) (len_sq y). intros.
  apply len_le; [lra|].
  assert (dot (vadd x y) (vadd x y) = dot x x + 2 * dot x y + dot y y) by (vdestruct; vunfold; ring).
  generalize (Rle_abs (dot x y)). nra.
Qed.
Lemma len_scale : forall k x, 0 <= k -> len (vscale k x) = k * len x.
Proof.
  intros k x Hk. unfold len. replace (dot (vscale k x) (vscale k x)) with (k * k * dot x x) by (vdestruct; vunfold;
    ring).
  rewrite sqrt_mult by (try apply dot_self_nonneg; nra). rewrite sqrt_square by auto. reflexivity.
Qed.
Lemma len_mono : forall x y, Rabs (vx x) <= vx y -> Rabs (vy x) <= vy y -> Rabs (vz x) <= vz y -> len x <= len y.
Proof.
  assert (S : forall r s, Rabs r <= s -> r * r <= s * s).
  { intros r s H. generalize (Rabs_pos r). replace (r * r) with (Rabs r * Rabs r). intro; nra.
    rewrite <- Rabs_mult. apply Rabs_pos_eq. nra. }
  intros x y H1 H2 H3. apply sqrt_le_1_alt. apply S in H1, H2, H3. unfold dot. lra.
Qed.
Lemma cross_len : forall x y, len (cross x y) <= len x * len y.
Proof.
  intros. apply len_le; [apply Rmult_le_pos; apply len_nonneg|].
  replace (len x * len y * (len x * len y)) with (len x * len x * (len y * len y)) by ring. rewrite !len_sq.
  assert (dot x x * dot y y - dot x y * dot x y = dot (cross x y) (cross x y)) by (vdestruct; vunfold; ring).
  generalize (dot x y) H. intros. nra.
Qed.

(* ---- The rounding of a cross product ---- *)

Definition rcross a b :=
  V (rnd (rnd (vy a * vz b) - rnd (vz a * vy b))) (rnd (rnd (vz a * vx b) - rnd (vx a * vz b)))
    (rnd (rnd (vx a * vy b) - rnd (vy a * vx b))).
Definition abscross a b :=
  V (Rabs (vy a * vz b) + Rabs (vz a * vy b)) (Rabs (vz a * vx b) + Rabs (vx a * vz b))
    (Rabs (vx a * vy b) + Rabs (vy a * vx b)).
Definition vabs x := V (Rabs (vx x)) (Rabs (vy x)) (Rabs (vz x)).

Lemma len_vabs : forall x, len (vabs x) = len x.
Proof.
  intros [x y z]. unfold len, vabs, dot; simpl. f_equal. rewrite <- !Rabs_mult, !Rabs_pos_eq by nra. reflexivity.
Qed.

Lemma abscross_len : forall a b, len (abscross a b) <= 1.4143 * (len a * len b).
Proof.
  intros a b. generalize (len_nonneg a) (len_nonneg b). intros La Lb.
  apply len_le; [apply Rmult_le_pos; [lra | apply Rmult_le_pos; auto]|].
  replace (1.4143 * (len a * len b) * (1.4143 * (len a * len b)))
    with (1.4143 * 1.4143 * ((len a * len a) * (len b * len b))) by ring. rewrite !len_sq.
  assert (P : 0 <= dot a a * dot b b) by (apply Rmult_le_pos; apply dot_self_nonneg).
  assert (A : forall r, Rabs r * Rabs r = r * r).
  { intros r. rewrite <- Rabs_mult. apply Rabs_pos_eq. nra. }
  apply Rle_trans with (2 * (dot a a * dot b b)); [|lra].
  unfold dot, abscross; simpl. rewrite !Rabs_mult.
  rewrite <- (A (vx a)), <- (A (vy a)), <- (A (vz a)), <- (A (vx b)), <- (A (vy b)), <- (A (vz b)).
  generalize (Rabs (vx a)) (Rabs (vy a)) (Rabs (vz a)) (Rabs (vx b)) (Rabs (vy b)) (Rabs (vz b)).
  clear. intros p q r x y z.
  generalize (Rle_0_sqr (p * x - q * y)) (Rle_0_sqr (q * y - r * z)) (Rle_0_sqr (r * z - p * x))
    (Rle_0_sqr (p * y - q * x)) (Rle_0_sqr (q * z - r * y)) (Rle_0_sqr (r * x - p * z)).
  unfold Rsqr. intros. nra.
Qed.

Lemma rnd_of_minus : forall p q, Rabs (rnd (rnd p - rnd q) - (p - q))
  <= u * Rabs (p - q) + (u + u * u) * (Rabs p + Rabs q) + 3 * u * tau.
Proof.
  intros p q. generalize (rnd_any p) (rnd_any q) (rnd_plus (rnd p) (- rnd q) (fmt_rnd p) (fmt_opp _ (fmt_rnd q))).
  change (rnd p + - rnd q) with (rnd p - rnd q). intros Hp Hq H.
  generalize u_pos u_val tau_pos. intros U0 Hu T0.
  assert (D : Rabs (rnd p - rnd q) <= Rabs (p - q) + (u * Rabs p + u * tau) + (u * Rabs q + u * tau)).
  { replace (rnd p - rnd q) with ((p - q) + ((rnd p - p) + - (rnd q - q))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. generalize (Rabs_triang (rnd p - p) (- (rnd q - q))).
    rewrite Rabs_Ropp. lra. }
  replace (rnd (rnd p - rnd q) - (p - q))
    with ((rnd (rnd p - rnd q) - (rnd p - rnd q)) + ((rnd p - p) + - (rnd q - q))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. generalize (Rabs_triang (rnd p - p) (- (rnd q - q))). rewrite Rabs_Ropp.
  assert (u * Rabs (rnd p - rnd q) <= u * (Rabs (p - q) + (u * Rabs p + u * tau) + (u * Rabs q + u * tau)))
    by (apply Rmult_le_compat_l; lra).
  assert (u * (2 * u * tau) <= u * tau).
  { apply Rmult_le_compat_l; [lra|]. rewrite Hu. lra. }
  lra.
Qed.

Lemma rcross_rounding : forall a b, len (vsub (rcross a b) (cross a b))
  <= (u + 1.4143 * (u + u * u)) * (len a * len b) + 6 * u * tau.
Proof.
  intros a b. generalize u_pos tau_pos. intros U0 T0.
  set (t := 3 * u * tau). assert (Ht : 0 <= t) by (unfold t; apply Rmult_le_pos; lra).
  apply Rle_trans with (len (vadd (vscale u (vabs (cross a b)))
                              (vadd (vscale (u + u * u) (abscross a b)) (V t t t)))).
  { apply len_mono; unfold rcross, cross, abscross, vabs, vadd, vscale, vsub; simpl;
      (eapply Rle_trans; [apply rnd_of_minus|]); unfold t; lra. }
  eapply Rle_trans; [apply len_triangle|].
  assert (L1 : len (vscale u (vabs (cross a b))) <= u * (len a * len b)).
  { rewrite len_scale by lra. apply Rmult_le_compat_l; [lra|].
    rewrite len_vabs. apply cross_len. }
  assert (L2 : len (vadd (vscale (u + u * u) (abscross a b)) (V t t t))
               <= (u + u * u) * (1.4143 * (len a * len b)) + 2 * t).
  { eapply Rle_trans; [apply len_triangle|]. apply Rplus_le_compat.
    - rewrite len_scale by nra. apply Rmult_le_compat_l; [nra | apply abscross_len].
    - apply len_le; [lra|]. unfold dot; simpl. nra. }
  unfold t in *. lra.
Qed.

(* ---- Rules ---- *)

Record napprox (e N : R) (a x : vec) : Prop := Napprox {
  n_fmt : fmt3 a;
  n_error : len (vsub a x) <= e * N;
  n_length : len x <= N;
  n_coefficient : 0 <= e }.

Lemma napprox_len : forall e N a x, napprox e N a x -> len a <= (1 + e) * N.
Proof.
  intros e N a x [_ He Hl _]. replace a with (vadd (vsub a x) x) by (apply vec_eq; simpl; ring).
  generalize (len_triangle (vsub a x) x). lra.
Qed.

Lemma napprox_difference : forall p q n, fmt3 p -> fmt3 q -> smallest_norm <= n -> n = rlen (rsub p q) ->
  napprox u (n * (1 + 4 * u)) (rsub p q) (vsub p q).
Proof.
  intros p q n Hp Hq Hn En. generalize u_pos u_val. intros U0 Hu.
  assert (Hv := vapprox_difference p q Hp Hq). assert (HL := rlen_lower _ _ Hv). rewrite <- En in HL. specialize (HL
    Hn).
  split; auto; [ | | lra].
  - destruct Hv as [[F1 _ _] [[F2 _ _] [F3 _ _]]]. repeat split; auto.
  - apply Rle_trans with (u * len (vsub p q)); [|apply Rmult_le_compat_l; lra].
    rewrite <- len_scale by lra.
    apply Rle_trans with (len (vscale u (vabs (vsub p q)))).
    + destruct Hv as [[_ E1 _] [[_ E2 _] [_ E3 _]]]. replace (E 1) with u in * by (unfold E; ring).
      apply len_mono; unfold vscale, vabs; simpl in *; auto.
    + right. rewrite !len_scale, len_vabs by lra. reflexivity.
Qed.

Lemma bilinear : forall e f N M la lb d1 d2 : R, 0 <= e -> 0 <= f -> 0 <= N -> 0 <= M ->
  0 <= d1 <= e * N -> 0 <= lb <= (1 + f) * M -> 0 <= la <= N -> 0 <= d2 <= f * M ->
  d1 * lb + la * d2 <= (e * (1 + f) + f) * (N * M).
Proof.
  intros. assert (d1 * lb <= e * N * ((1 + f) * M)) by (apply Rmult_le_compat; lra).
  assert (la * d2 <= N * (f * M)) by (apply Rmult_le_compat; lra). lra.
Qed.

Lemma napprox_cross : forall e f N M a b x y g, napprox e N a x -> napprox f M b y ->
  tau <= / 10 ^ 40 * (N * M) ->
  e * (1 + f) + f + (u + 1.4143 * (u + u * u)) * ((1 + e) * (1 + f)) + / 10 ^ 30 <= g ->
  napprox g (N * M) (rcross a b) (cross x y).
Proof.
  intros e f N M a b x y g Ha Hb T1 Hg.
  generalize (napprox_len _ _ _ _ Ha) (napprox_len _ _ _ _ Hb). intros La Lb.
  destruct Ha as [Fa Ea Xa Ca], Hb as [Fb Eb Xb Cb].
  generalize u_pos u_val tau_pos. intros U0 Hu T0.
  generalize (len_nonneg a) (len_nonneg b) (len_nonneg x) (len_nonneg y) (len_nonneg (vsub a x))
    (len_nonneg (vsub b y)). intros.
  assert (K : 0 <= u + 1.4143 * (u + u * u)) by nra.
  assert (N0 : 0 <= N) by (eapply Rle_trans; [|exact Xa]; auto). assert (M0 : 0 <= M) by (eapply Rle_trans; [|exact Xb];
    auto).  assert (NM0 : 0 <= N * M) by (apply Rmult_le_pos; auto).
  split.
  - repeat split; apply fmt_rnd.
  - replace (vsub (rcross a b) (cross x y)) with
      (vadd (vsub (rcross a b) (cross a b)) (vadd (cross (vsub a x) b) (cross x (vsub b y))))
      by (apply vec_eq; unfold cross, vsub, vadd; simpl; ring).
    eapply Rle_trans; [apply len_triangle|]. eapply Rle_trans.
    { apply Rplus_le_compat; [apply rcross_rounding | apply len_triangle]. }
    generalize (cross_len (vsub a x) b) (cross_len x (vsub b y)). intros C1 C2.
    assert (B : len (vsub a x) * len b + len x * len (vsub b y) <= (e * (1 + f) + f) * (N * M))
      by (apply bilinear; auto; split; auto).
    assert (R1 : len a * len b <= (1 + e) * N * ((1 + f) * M)) by (apply Rmult_le_compat; auto).
    assert (R2 : (u + 1.4143 * (u + u * u)) * (len a * len b) <= (u + 1.4143 * (u + u * u)) * ((1 + e) * N * ((1 + f) *
      M)))
      by (apply Rmult_le_compat_l; auto).
    assert (R3 : 6 * u * tau <= / 10 ^ 30 * (N * M)).
    { apply Rle_trans with (6 * tau); [rewrite Hu; lra | lra]. }
    assert (G : (e * (1 + f) + f + (u + 1.4143 * (u + u * u)) * ((1 + e) * (1 + f)) + / 10 ^ 30) * (N * M) <= g * (N *
      M))
      by (apply Rmult_le_compat_r; auto).
    lra.
  - eapply Rle_trans; [apply cross_len|]. apply Rmult_le_compat; auto.
  - eapply Rle_trans; [|exact Hg].
    assert (0 <= e * (1 + f)) by (apply Rmult_le_pos; lra).
    assert (0 <= (u + 1.4143 * (u + u * u)) * ((1 + e) * (1 + f))) by (apply Rmult_le_pos; auto; apply Rmult_le_pos;
      lra).
    lra.
Qed.

Lemma napprox_dot : forall e f N M a b x y, napprox e N a x -> napprox f M b y ->
  tau <= / 10 ^ 40 * (N * M) ->
  Rabs (rdot a b - dot x y) <= (e * (1 + f) + f + 3.0001 * u * ((1 + e) * (1 + f)) + / 10 ^ 30) * (N * M).
Proof.
  intros e f N M a b x y Ha Hb T1.
  generalize (napprox_len _ _ _ _ Ha) (napprox_len _ _ _ _ Hb). intros La Lb.
  destruct Ha as [[Fa1 [Fa2 Fa3]] Ea Xa Ca], Hb as [[Fb1 [Fb2 Fb3]] Eb Xb Cb].
  generalize u_pos u_val tau_pos. intros U0 Hu T0.
  generalize (len_nonneg a) (len_nonneg b) (len_nonneg x) (len_nonneg y) (len_nonneg (vsub a x))
    (len_nonneg (vsub b y)). intros.
  assert (N0 : 0 <= N) by (eapply Rle_trans; [|exact Xa]; auto). assert (M0 : 0 <= M) by (eapply Rle_trans; [|exact Xb];
    auto).  assert (NM0 : 0 <= N * M) by (apply Rmult_le_pos; auto).
  assert (Va : vapprox 0 a a) by (repeat split; simpl; apply approx_exact; auto).
  assert (Vb : vapprox 0 b b) by (repeat split; simpl; apply approx_exact; auto).
  destruct (rdot_approx 0 0 _ _ _ _ Va Vb) as [_ Er _]. change (0 + 0 + 3)%nat with 3%nat in Er.
  replace (rdot a b - dot x y) with ((rdot a b - dot a b) + (dot (vsub a x) b + dot x (vsub b y)))
    by (unfold dot, vsub; simpl; ring).
  eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans.
  { apply Rplus_le_compat; [exact Er | apply Rabs_triang]. }
  generalize (dot_len (vsub a x) b) (dot_len x (vsub b y)) (absdot_len a b). intros C1 C2 C3.
  assert (B : len (vsub a x) * len b + len x * len (vsub b y) <= (e * (1 + f) + f) * (N * M))
    by (apply bilinear; auto; split; auto).
  assert (R1 : len a * len b <= (1 + e) * N * ((1 + f) * M)) by (apply Rmult_le_compat; auto).
  assert (E3 : E 3 <= 3.0001 * u) by (unfold E; rewrite Hu; simpl; lra).
  assert (E30 := E_nonneg 3).
  assert (R2 : E 3 * (absdot a b + 3 * tau) <= 3.0001 * u * ((1 + e) * N * ((1 + f) * M) + 3 * tau)).
  { apply Rmult_le_compat; try lra. generalize (Rabs_pos (dot a b)) (absdot_dot a b). lra. }
  assert (R3 : 3.0001 * u * (3 * tau) <= / 10 ^ 30 * (N * M)).
  { apply Rle_trans with (6 * tau); [rewrite Hu; lra | lra]. }
  lra.
Qed.

(* ---- Scalars and sums ---- *)

Record sapprox (e M s t : R) : Prop := Sapprox {
  s_fmt : fmt s;
  s_error : Rabs (s - t) <= e * M;
  s_size : Rabs t <= M;
  s_coefficient : 0 <= e }.

Lemma sapprox_dot : forall e f N M a b x y g, napprox e N a x -> napprox f M b y ->
  tau <= / 10 ^ 40 * (N * M) ->
  e * (1 + f) + f + 3.0001 * u * ((1 + e) * (1 + f)) + / 10 ^ 30 <= g ->
  sapprox g (N * M) (rdot a b) (dot x y).
Proof.
  intros e f N M a b x y g Ha Hb T1 Hg.
  assert (D := napprox_dot _ _ _ _ _ _ _ _ Ha Hb T1).
  destruct Ha as [_ _ Xa Ca], Hb as [_ _ Xb Cb]. generalize u_pos (len_nonneg x) (len_nonneg y). intros U0 Lx Ly.
  assert (NM0 : 0 <= N * M) by (apply Rmult_le_pos; lra).
  split.
  - apply fmt_rnd.
  - eapply Rle_trans; [exact D|]. apply Rmult_le_compat_r; auto.
  - eapply Rle_trans; [apply dot_len|]. apply Rmult_le_compat; auto.
  - eapply Rle_trans; [|exact Hg].
    assert (0 <= e * (1 + f)) by (apply Rmult_le_pos; lra).
    assert (0 <= 3.0001 * u * ((1 + e) * (1 + f))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]). lra.
Qed.

Definition rscale s a := V (rnd (s * vx a)) (rnd (s * vy a)) (rnd (s * vz a)).
Definition radd a b := V (rnd (vx a + vx b)) (rnd (vy a + vy b)) (rnd (vz a + vz b)).

Lemma len_scale_any : forall k x, len (vscale k x) = Rabs k * len x.
Proof.
  intros k x. unfold len.
  replace (dot (vscale k x) (vscale k x)) with (k * k * dot x x) by (vdestruct; vunfold; ring).
  rewrite sqrt_mult by (try apply dot_self_nonneg; nra). rewrite <- sqrt_Rsqr_abs. reflexivity.
Qed.

Lemma napprox_scale : forall e f M N s t a x g, sapprox e M s t -> napprox f N a x ->
  tau <= / 10 ^ 40 * (M * N) ->
  e * (1 + f) + f + u * ((1 + e) * (1 + f)) + / 10 ^ 30 <= g ->
  napprox g (M * N) (rscale s a) (vscale t x).
Proof.
  intros e f M N s t a x g Hs Ha T1 Hg. assert (La := napprox_len _ _ _ _ Ha).
  destruct Hs as [Fs Es Ss Cs], Ha as [_ Ea Xa Ca].
  generalize u_pos u_val tau_pos (len_nonneg a) (len_nonneg x) (len_nonneg (vsub a x)) (Rabs_pos s) (Rabs_pos t)
    (Rabs_pos (s - t)). intros.
  assert (S1 : Rabs s <= (1 + e) * M).
  { replace s with ((s - t) + t) by ring. generalize (Rabs_triang (s - t) t). lra. }
  assert (M0 : 0 <= M) by (eapply Rle_trans; [|exact Ss]; auto).
  assert (N0 : 0 <= N) by (eapply Rle_trans; [|exact Xa]; auto).
  assert (MN0 : 0 <= M * N) by (apply Rmult_le_pos; auto).
  split.
  - repeat split; apply fmt_rnd.
  - replace (vsub (rscale s a) (vscale t x)) with
      (vadd (vsub (rscale s a) (vscale s a)) (vadd (vscale (s - t) a) (vscale t (vsub a x))))
      by (apply vec_eq; unfold vscale, vsub, vadd; simpl; ring).
    eapply Rle_trans; [apply len_triangle|].
    eapply Rle_trans; [apply Rplus_le_compat; [|apply len_triangle]|].
    + apply Rle_trans with (len (vadd (vscale u (vabs (vscale s a))) (V (u * tau) (u * tau) (u * tau)))).
      * apply len_mono; unfold rscale, vscale, vabs, vadd, vsub; simpl; apply rnd_any.
      * eapply Rle_trans; [apply len_triangle|]. rewrite len_scale, len_vabs, len_scale_any by lra.
        apply Rplus_le_compat; [apply Rle_refl|]. apply (len_le _ (2 * (u * tau))); [nra|]. unfold dot; simpl. nra.
    + rewrite !len_scale_any.
      assert (B : Rabs (s - t) * len a + Rabs t * len (vsub a x) <= (e * (1 + f) + f) * (M * N))
        by (apply bilinear; auto; split; auto).
      assert (R1 : Rabs s * len a <= (1 + e) * M * ((1 + f) * N)) by (apply Rmult_le_compat; auto).
      assert (R2 : u * (Rabs s * len a) <= u * ((1 + e) * M * ((1 + f) * N))) by (apply Rmult_le_compat_l; lra).
      assert (R3 : 2 * (u * tau) <= / 10 ^ 30 * (M * N)).
      { apply Rle_trans with (2 * tau); [rewrite H0; lra | lra]. }
      assert (G : (e * (1 + f) + f + u * ((1 + e) * (1 + f)) + / 10 ^ 30) * (M * N) <= g * (M * N))
        by (apply Rmult_le_compat_r; auto).
      lra.
  - rewrite len_scale_any. apply Rmult_le_compat; auto.
  - eapply Rle_trans; [|exact Hg].
    assert (0 <= e * (1 + f)) by (apply Rmult_le_pos; lra).
    assert (0 <= u * ((1 + e) * (1 + f))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]). lra.
Qed.

Lemma napprox_add : forall e N M a b x y g, napprox e N a x -> napprox e M b y -> e + u * (1 + e) <= g ->
  napprox g (N + M) (radd a b) (vadd x y).
Proof.
  intros e N M a b x y g Ha Hb Hg.
  generalize (napprox_len _ _ _ _ Ha) (napprox_len _ _ _ _ Hb). intros La Lb.
  destruct Ha as [[Fa1 [Fa2 Fa3]] Ea Xa Ca], Hb as [[Fb1 [Fb2 Fb3]] Eb Xb _].
  generalize u_pos (len_nonneg x) (len_nonneg y). intros.
  split.
  - repeat split; apply fmt_rnd.
  - replace (vsub (radd a b) (vadd x y)) with (vadd (vsub (radd a b) (vadd a b)) (vadd (vsub a x) (vsub b y)))
      by (apply vec_eq; unfold vsub, vadd; simpl; ring).
    eapply Rle_trans; [apply len_triangle|].
    eapply Rle_trans; [apply Rplus_le_compat; [|apply len_triangle]|].
    + apply Rle_trans with (len (vscale u (vabs (vadd a b)))).
      * apply len_mono; unfold radd, vscale, vabs, vadd, vsub; simpl; apply rnd_plus; auto.
      * rewrite len_scale, len_vabs by lra. apply Rmult_le_compat_l; [lra | apply len_triangle].
    + assert (u * (len a + len b) <= u * ((1 + e) * (N + M))) by (apply Rmult_le_compat_l; lra).
      assert (NM : 0 <= N + M) by lra.
      assert ((e + u * (1 + e)) * (N + M) <= g * (N + M)) by (apply Rmult_le_compat_r; auto). lra.
  - eapply Rle_trans; [apply len_triangle|]. lra.
  - assert (0 <= u * (1 + e)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma napprox_weaken : forall e f N a x, napprox e N a x -> e <= f -> napprox f N a x.
Proof.
  intros e f N a x [F He Hx C] H. split; auto; [|lra].
  eapply Rle_trans; [exact He|]. apply Rmult_le_compat_r; auto. eapply Rle_trans; [apply len_nonneg | exact Hx].
Qed.
Lemma sapprox_mult : forall e f M N s t x y g, sapprox e M s x -> sapprox f N t y -> tau <= / 10 ^ 40 * (M * N) ->
  e * (1 + f) + f + u * ((1 + e) * (1 + f)) + / 10 ^ 30 <= g -> sapprox g (M * N) (rnd (s * t)) (x * y).
Proof.
  intros e f M N s t x y g [_ Es Ss Cs] [_ Et St Ct] T1 Hg.
  generalize u_pos u_val tau_pos (Rabs_pos s) (Rabs_pos t) (Rabs_pos x) (Rabs_pos y) (Rabs_pos (s - x)) (Rabs_pos (t -
    y)).
  intros U0 Hu T0 P1 P2 P3 P4 P5 P6.
  assert (S1 : Rabs s <= (1 + e) * M).
  { replace s with ((s - x) + x) by ring. generalize (Rabs_triang (s - x) x). lra. }
  assert (S2 : Rabs t <= (1 + f) * N).
  { replace t with ((t - y) + y) by ring. generalize (Rabs_triang (t - y) y). lra. }
  assert (M0 : 0 <= M) by (eapply Rle_trans; [|exact Ss]; auto).
  assert (N0 : 0 <= N) by (eapply Rle_trans; [|exact St]; auto).
  assert (MN0 : 0 <= M * N) by (apply Rmult_le_pos; auto).
  split.
  - apply fmt_rnd.
  - replace (rnd (s * t) - x * y) with ((rnd (s * t) - s * t) + ((s - x) * t + x * (t - y))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat; [apply rnd_any | apply
      Rabs_triang]|].
    rewrite !Rabs_mult.
    assert (B : Rabs (s - x) * Rabs t + Rabs x * Rabs (t - y) <= (e * (1 + f) + f) * (M * N))
      by (apply bilinear; auto; split; auto).
    assert (R1 : Rabs s * Rabs t <= (1 + e) * M * ((1 + f) * N)) by (apply Rmult_le_compat; auto).
    assert (R2 : u * (Rabs s * Rabs t) <= u * ((1 + e) * M * ((1 + f) * N))) by (apply Rmult_le_compat_l; lra).
    assert (R3 : u * tau <= / 10 ^ 30 * (M * N)) by (apply Rle_trans with tau; [rewrite Hu; lra | lra]).
    assert (G : (e * (1 + f) + f + u * ((1 + e) * (1 + f)) + / 10 ^ 30) * (M * N) <= g * (M * N))
      by (apply Rmult_le_compat_r; auto).
    lra.
  - rewrite Rabs_mult. apply Rmult_le_compat; auto.
  - eapply Rle_trans; [|exact Hg].
    assert (0 <= e * (1 + f)) by (apply Rmult_le_pos; lra).
    assert (0 <= u * ((1 + e) * (1 + f))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]). lra.
Qed.
Lemma sapprox_minus : forall e M N s t x y g, sapprox e M s x -> sapprox e N t y -> e + u * (1 + e) <= g ->
  sapprox g (M + N) (rnd (s - t)) (x - y).
Proof.
  intros e M N s t x y g [Fs Es Ss Cs] [Ft Et St _] Hg.
  generalize u_pos (Rabs_pos x) (Rabs_pos y). intros.
  assert (D : Rabs ((s - x) - (t - y)) <= e * (M + N)).
  { generalize (Rabs_triang (s - x) (- (t - y))). rewrite Rabs_Ropp.
    replace ((s - x) - (t - y)) with ((s - x) + - (t - y)) by ring. lra. }
  assert (XY : Rabs (x - y) <= M + N).
  { generalize (Rabs_triang x (- y)). rewrite Rabs_Ropp. replace (x - y) with (x + - y) by ring. lra. }
  assert (ST : Rabs (s - t) <= (1 + e) * (M + N)).
  { replace (s - t) with ((s - x - (t - y)) + (x - y)) by ring. generalize (Rabs_triang (s - x - (t - y)) (x - y)). lra.
    }
  split; auto.
  - apply fmt_rnd.
  - replace (rnd (s - t) - (x - y)) with ((rnd (s - t) - (s - t)) + ((s - x) - (t - y))) by ring.
    eapply Rle_trans; [apply Rabs_triang|].
    generalize (rnd_plus s (- t) Fs (fmt_opp _ Ft)). change (s + - t) with (s - t). intro R.
    assert (u * Rabs (s - t) <= u * ((1 + e) * (M + N))) by (apply Rmult_le_compat_l; lra).
    assert (NM : 0 <= M + N) by lra.
    assert ((e + u * (1 + e)) * (M + N) <= g * (M + N)) by (apply Rmult_le_compat_r; auto). lra.
  - assert (0 <= u * (1 + e)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma sapprox_opp : forall e N a x, sapprox e N a x -> sapprox e N (- a) (- x).
Proof.
  intros e N a x [F He Hx C]. split; auto.
  - apply fmt_opp; auto.
  - replace (- a - - x) with (- (a - x)) by ring. rewrite Rabs_Ropp. exact He.
  - rewrite Rabs_Ropp. exact Hx.
Qed.
Lemma sapprox_weaken : forall e f N a x, sapprox e N a x -> e <= f -> sapprox f N a x.
Proof.
  intros e f N a x [F He Hx C] H. split; auto; [|lra].
  eapply Rle_trans; [exact He|]. apply Rmult_le_compat_r; auto. eapply Rle_trans; [apply Rabs_pos | exact Hx].
Qed.
