(* Vectors of doubles: dot products and norms, as src/geometry/vector3.h computes them. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 filters.Rounding.
Open Scope R_scope.

Definition len x := sqrt (dot x x).
Definition fmt3 p := fmt (vx p) /\ fmt (vy p) /\ fmt (vz p).
Definition rsub p q := V (rnd (vx p - vx q)) (rnd (vy p - vy q)) (rnd (vz p - vz q)).
Definition rdot a b := rnd (rnd (rnd (vx a * vx b) + rnd (vy a * vy b)) + rnd (vz a * vz b)).
Definition rlen a := rnd (sqrt (rdot a a)).

Definition vapprox k a x :=
  approx k (Rabs (vx x)) (vx a) (vx x) /\ approx k (Rabs (vy x)) (vy a) (vy x) /\ approx k (Rabs (vz x)) (vz a) (vz x).
Definition absdot x y := Rabs (vx x) * Rabs (vx y) + Rabs (vy x) * Rabs (vy y) + Rabs (vz x) * Rabs (vz y).

Lemma vapprox_difference : forall p q, fmt3 p -> fmt3 q -> vapprox 1 (rsub p q) (vsub p q).
Proof. intros p q [? [? ?]] [? [? ?]]. repeat split; simpl; apply approx_difference; auto. Qed.

Lemma rdot_approx : forall j k a b x y, vapprox j a x -> vapprox k b y ->
  approx (j + k + 3) (absdot x y + 3 * tau) (rdot a b) (dot x y).
Proof.
  intros j k a b x y [X1 [Y1 Z1]] [X2 [Y2 Z2]].
  unfold rdot, dot. generalize tau_pos; intro T.
  eapply approx_weaken; [| | apply approx_plus with (k := (j + k + 2)%nat);
    [ eapply approx_weaken; [| | apply approx_plus with (k := (j + k + 1)%nat);
        [ eapply approx_weaken; [| | apply approx_mult; eauto]; [lia | apply Rle_refl]
        | eapply approx_weaken; [| | apply approx_mult; eauto]; [lia | apply Rle_refl] ] ]; [lia | apply Rle_refl]
    | eapply approx_weaken; [| | apply approx_mult; eauto]; [lia | apply Rle_refl] ] ].
  - lia.
  - unfold absdot. lra.
Qed.

Lemma absdot_len : forall x y, absdot x y <= len x * len y.
Proof.
  intros x y. unfold len. rewrite <- sqrt_mult by apply dot_self_nonneg.
  apply Rsqr_incr_0_var; [|apply sqrt_pos]. rewrite Rsqr_sqrt by (apply Rmult_le_pos; apply dot_self_nonneg).
  set (x' := V (Rabs (vx x)) (Rabs (vy x)) (Rabs (vz x))). set (y' := V (Rabs (vx y)) (Rabs (vy y)) (Rabs (vz y))).
  assert (A : forall r, Rabs r * Rabs r = r * r).
  { intros r. rewrite <- Rabs_mult. apply Rabs_pos_eq. nra. }
  assert (Ex : dot x x = dot x' x') by (unfold dot, x'; simpl; rewrite !A; ring).
  assert (Ey : dot y y = dot y' y') by (unfold dot, y'; simpl; rewrite !A; ring).
  rewrite Ex, Ey. change (absdot x y) with (dot x' y'). unfold Rsqr.
  assert (F : dot x' x' * dot y' y' - dot x' y' * dot x' y' = dot (cross x' y') (cross x' y')).
  { generalize x' y'. clear. intros. vdestruct; vunfold; ring. }
  generalize (dot_self_nonneg (cross x' y')); lra.
Qed.
Lemma absdot_self : forall x, absdot x x = dot x x.
Proof. intros. unfold absdot, dot. rewrite <- !Rabs_mult, !Rabs_pos_eq by nra. reflexivity. Qed.

(* The guard of every filter: kSmallestNorm. *)
Definition smallest_norm := / 10 ^ 42 * (1 - u).

(* A computed norm that passes the guard is not much smaller than the true one: 1 + 4 u covers it. *)
Lemma rlen_lower : forall a x, vapprox 1 a x -> smallest_norm <= rlen a -> len x <= rlen a * (1 + 4 * u).
Proof.
  intros a x Ha Hn.
  generalize (rdot_approx 1 1 _ _ _ _ Ha Ha). change (1 + 1 + 3)%nat with 5%nat. rewrite absdot_self.
  intros [_ HS _].
  set (n := rlen a) in *. set (S := rdot a a) in *. set (s := sqrt S).
  assert (Hr : Rabs (n - s) <= u * Rabs s + u * tau) by apply rnd_any.
  assert (Hs0 : 0 <= s) by apply sqrt_pos. rewrite (Rabs_pos_eq s Hs0) in Hr.
  generalize tau_pos tau_small u_pos. intros T0 T1 U0.
  set (A := dot x x) in *. assert (A0 : 0 <= A) by apply dot_self_nonneg.
  assert (Hu : u = / 9007199254740992) by apply u_val.
  unfold smallest_norm in Hn.
  assert (N0 : / 10 ^ 43 <= n) by (eapply Rle_trans; [|exact Hn]; rewrite Hu; lra).
  assert (T2 : tau <= / 10 ^ 200 * n) by (eapply Rle_trans; [exact T1|]; lra).
  assert (N2 : / 10 ^ 86 <= n * n).
  { replace (/ 10 ^ 86) with (/ 10 ^ 43 * / 10 ^ 43) by field. apply Rmult_le_compat; lra. }
  assert (T3 : tau <= / 10 ^ 200 * (n * n)) by (eapply Rle_trans; [exact T1|]; lra).
  apply Rabs_le_inv in Hr. apply Rabs_le_inv in HS.
  assert (Hs1 : s * (1 - u) <= n * (1 + / 10 ^ 200)) by (rewrite Hu in *; lra).
  assert (HSs : S = s * s).
  { unfold s. rewrite sqrt_sqrt; auto. destruct (Rle_or_lt 0 S) as [|Neg]; auto. exfalso.
    unfold s in Hr. rewrite (sqrt_neg_0 S) in Hr by lra. rewrite Hu in Hr. lra. }
  assert (Hs2 : S * ((1 - u) * (1 - u)) <= n * n * ((1 + / 10 ^ 200) * (1 + / 10 ^ 200))).
  { rewrite HSs. replace (s * s * ((1 - u) * (1 - u))) with ((s * (1 - u)) * (s * (1 - u))) by ring.
    replace (n * n * ((1 + / 10 ^ 200) * (1 + / 10 ^ 200))) with ((n * (1 + / 10 ^ 200)) * (n * (1 + / 10 ^ 200))) by
      ring.
    assert (0 <= s * (1 - u)) by (apply Rmult_le_pos; rewrite ?Hu; lra).
    apply Rmult_le_compat; auto. }
  assert (E5 : E 5 <= 5.0001 * u) by (unfold E; rewrite Hu; simpl; lra).
  assert (E50 := E_nonneg 5).
  assert (HA : A * (1 - 5.0001 * u) <= S + / 10 ^ 200 * (n * n)).
  { assert (E 5 * (A + 3 * tau) <= 5.0001 * u * (A + 3 * tau)) by (apply Rmult_le_compat_r; lra).
    rewrite Hu in *. lra. }
  assert (HA2 : A <= n * n * ((1 + 4 * u) * (1 + 4 * u))).
  { rewrite Hu in *. lra. }
  unfold len. fold A. apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra].
  rewrite Rsqr_sqrt by auto. unfold Rsqr. lra.
Qed.
