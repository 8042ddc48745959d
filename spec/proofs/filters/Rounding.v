(* Errors of double arithmetic, counted in roundings.
   approx k M a x: the double a stands for the real x, |x| <= M, and |a - x| <= ((1+u)^k - 1) M.
   A product adds the counts and one, a sum takes the larger and one. Underflow of a product is paid for by its
   magnitude: tau, the smallest normal double, is added to it. Sums never underflow. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative Plus_error.
Open Scope R_scope.

Global Instance prec_positive : Prec_gt_0 53 := eq_refl.

Notation fexp := (FLT_exp (-1074) 53).
Definition fmt := generic_format radix2 fexp.
Definition rnd := round radix2 fexp ZnearestE.
Definition u := bpow radix2 (-53).
Definition tau := bpow radix2 (-1022).

Lemma u_val : u = / 9007199254740992.
Proof. unfold u; simpl. reflexivity. Qed.
Lemma u_pos : 0 < u. Proof. apply bpow_gt_0. Qed.
Lemma tau_pos : 0 < tau. Proof. apply bpow_gt_0. Qed.
Lemma tau_small : tau <= / 10 ^ 300.
Proof.
  unfold tau. change (bpow radix2 (-1022)) with (/ IZR (Z.pow_pos 2 1022)).
  apply Rinv_le; [apply pow_lt; lra|]. rewrite pow_IZR. apply IZR_le.
  apply Z.leb_le. vm_compute. reflexivity.
Qed.

Lemma fmt_rnd : forall x, fmt (rnd x).
Proof. intros. apply generic_format_round; [apply FLT_exp_valid; reflexivity | apply valid_rnd_N]. Qed.
Lemma fmt_opp : forall x, fmt x -> fmt (- x).
Proof. intros. apply generic_format_opp; auto. Qed.

Lemma u_ro_u : u_ro radix2 53 = u.
Proof.
  unfold u_ro, u. change (- (53))%Z with (-53)%Z. rewrite bpow_plus. replace (bpow radix2 1) with 2 by reflexivity.
  generalize (bpow radix2 (-53)); intro; field.
Qed.
Lemma u_ro1 : u_ro radix2 53 / (1 + u_ro radix2 53) <= u.
Proof. eapply Rle_trans; [apply u_rod1pu_ro_le_u_ro | rewrite u_ro_u; apply Rle_refl]. Qed.

(* One rounding. *)
Lemma rnd_any : forall x, Rabs (rnd x - x) <= u * Rabs x + u * tau.
Proof.
  intros x. destruct (error_N_FLT radix2 (-1074) 53 eq_refl (fun t => negb (Z.even t)) x)
    as [d [e [Hd [He [_ H]]]]].
  unfold rnd. rewrite H.
  replace (x * (1 + d) + e - x) with (x * d + e) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (Hd' : Rabs d <= u).
  { rewrite <- u_ro_u. exact Hd. }
  assert (He' : Rabs e <= u * tau).
  { unfold u, tau. rewrite <- bpow_plus. eapply Rle_trans; [exact He|].
    replace (-53 + -1022)%Z with (-1 + -1074)%Z by reflexivity. rewrite bpow_plus. replace (bpow radix2 (-1)) with (/ 2)
      by reflexivity. apply Rle_refl. }
  generalize (Rabs_pos x); nra.
Qed.
Lemma rnd_plus : forall x y, fmt x -> fmt y -> Rabs (rnd (x + y) - (x + y)) <= u * Rabs (x + y).
Proof.
  intros x y Hx Hy.
  destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun t => negb (Z.even t)) x y Hx Hy) as [d [Hd H]].
  unfold rnd. rewrite H.
  replace ((x + y) * (1 + d) - (x + y)) with (d * (x + y)) by ring. rewrite Rabs_mult.
  apply Rmult_le_compat_r; [apply Rabs_pos|]. eapply Rle_trans; [exact Hd | apply u_ro1].
Qed.

(* ---- Counted errors ---- *)

Definition E k := (1 + u) ^ k - 1.
Lemma pow_ge_1 : forall k, 1 <= (1 + u) ^ k.
Proof. intros. apply pow_R1_Rle. generalize u_pos; lra. Qed.
Lemma E_mono : forall j k, (j <= k)%nat -> E j <= E k.
Proof.
  intros. unfold E. assert ((1 + u) ^ j <= (1 + u) ^ k) by (apply Rle_pow; [generalize u_pos; lra | auto]). lra.
Qed.
Lemma E_nonneg : forall k, 0 <= E k.
Proof. intros; unfold E; generalize (pow_ge_1 k); lra. Qed.

Record approx (k : nat) (M a x : R) : Prop := Approx {
  approx_fmt : fmt a;
  approx_error : Rabs (a - x) <= E k * M;
  approx_magnitude : Rabs x <= M }.

Lemma approx_weaken : forall j k M N a x, (j <= k)%nat -> M <= N -> approx j M a x -> approx k N a x.
Proof.
  intros j k M N a x Hk HM [F He Hm]. split; auto; [|lra].
  eapply Rle_trans; [exact He|]. generalize (E_mono j k Hk) (E_nonneg j) (Rabs_pos x). intros.
  apply Rmult_le_compat; lra.
Qed.
Lemma approx_size : forall k M a x, approx k M a x -> Rabs a <= (1 + u) ^ k * M.
Proof.
  intros k M a x [_ He Hm]. replace a with ((a - x) + x) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. unfold E in He. lra.
Qed.

Lemma approx_exact : forall a, fmt a -> approx 0 (Rabs a) a a.
Proof. intros. split; auto; [|lra]. unfold E; simpl. replace (a - a) with 0 by ring. rewrite Rabs_R0. lra. Qed.

Lemma approx_difference : forall p q, fmt p -> fmt q -> approx 1 (Rabs (q - p)) (rnd (q - p)) (q - p).
Proof.
  intros p q Hp Hq. split; [apply fmt_rnd| |lra].
  replace (E 1) with u by (unfold E; ring). apply (rnd_plus q (- p)); auto. apply fmt_opp; auto.
Qed.

Lemma approx_mult : forall j k M N a b x y,
  approx j M a x -> approx k N b y -> approx (S (j + k)) (M * N + tau) (rnd (a * b)) (x * y).
Proof.
  intros j k M N a b x y Ha Hb.
  generalize (approx_size _ _ _ _ Ha) (approx_size _ _ _ _ Hb). intros Sa Sb.
  destruct Ha as [_ Ea Ma], Hb as [_ Eb Mb].
  generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos a) (Rabs_pos b). intros.
  assert (M0 : 0 <= M) by lra. assert (N0 : 0 <= N) by lra.
  generalize (pow_ge_1 j) (pow_ge_1 k) u_pos tau_pos. intros Pj Pk Hu Ht.
  assert (Sab : Rabs (a * b) <= (1 + u) ^ j * (1 + u) ^ k * (M * N)).
  { rewrite Rabs_mult. eapply Rle_trans; [apply Rmult_le_compat; eauto|]. right; ring. }
  split; [apply fmt_rnd| |].
  - replace (rnd (a * b) - x * y) with ((rnd (a * b) - a * b) + ((a - x) * b + x * (b - y))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans.
    { apply Rplus_le_compat; [apply rnd_any | apply Rabs_triang]. }
    rewrite (Rabs_mult (a - x)), (Rabs_mult x).
    assert (T1 : Rabs (a - x) * Rabs b <= E j * M * ((1 + u) ^ k * N))
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (T2 : Rabs x * Rabs (b - y) <= M * (E k * N))
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (T3 : u * Rabs (a * b) <= u * ((1 + u) ^ j * (1 + u) ^ k * (M * N)))
      by (apply Rmult_le_compat_l; lra).
    assert (Q : E (S (j + k)) * (M * N) = E j * M * ((1 + u) ^ k * N) + M * (E k * N)
                + u * ((1 + u) ^ j * (1 + u) ^ k * (M * N))).
    { unfold E. rewrite <- tech_pow_Rmult, pow_add. ring. }
    assert (Q2 : u * tau <= E (S (j + k)) * tau).
    { apply Rmult_le_compat_r; [lra|]. unfold E. rewrite <- tech_pow_Rmult. generalize (pow_ge_1 (j + k)). nra. }
    rewrite Rmult_plus_distr_l, Q. lra.
  - rewrite Rabs_mult. assert (Rabs x * Rabs y <= M * N) by (apply Rmult_le_compat; auto). lra.
Qed.

Lemma approx_plus : forall k M N a b x y,
  approx k M a x -> approx k N b y -> approx (S k) (M + N) (rnd (a + b)) (x + y).
Proof.
  intros k M N a b x y Ha Hb.
  generalize (approx_size _ _ _ _ Ha) (approx_size _ _ _ _ Hb). intros Sa Sb.
  destruct Ha as [Fa Ea Ma], Hb as [Fb Eb Mb]. generalize u_pos; intro Hu.
  split; [apply fmt_rnd| |].
  - replace (rnd (a + b) - (x + y)) with ((rnd (a + b) - (a + b)) + ((a - x) + (b - y))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans.
    { apply Rplus_le_compat; [apply rnd_plus; auto | apply Rabs_triang]. }
    generalize (Rabs_triang a b). intro T.
    assert (u * Rabs (a + b) <= u * ((1 + u) ^ k * (M + N))) by (apply Rmult_le_compat_l; lra).
    unfold E in *. rewrite <- tech_pow_Rmult. lra.
  - generalize (Rabs_triang x y). lra.
Qed.
