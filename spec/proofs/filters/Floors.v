(* Products of norms that passed the guard are far above underflow; computed bounds from below. *)
From Coq Require Import Reals Lra Psatz Lia.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 filters.Rounding filters.RoundedVectors.
Open Scope R_scope.

Lemma floor_mult : forall j k x y, / 10 ^ j <= x -> / 10 ^ k <= y -> / 10 ^ (j + k) <= x * y.
Proof.
  intros j k x y Hx Hy.
  assert (Pj : 0 < 10 ^ j) by (apply pow_lt; lra). assert (Pk : 0 < 10 ^ k) by (apply pow_lt; lra).
  rewrite pow_add. replace (/ (10 ^ j * 10 ^ k)) with (/ 10 ^ j * / 10 ^ k) by (field; lra).
  apply Rmult_le_compat; auto; left; apply Rinv_0_lt_compat; auto.
Qed.
Lemma floor_tau : forall k x, (k <= 260)%nat -> / 10 ^ k <= x -> tau <= / 10 ^ 40 * x.
Proof.
  intros k x Hk H. eapply Rle_trans; [apply tau_small|].
  assert (/ 10 ^ 260 <= / 10 ^ k) by (apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | auto]]).
  assert (/ 10 ^ 40 * / 10 ^ 260 <= / 10 ^ 40 * x) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma rnd_lower : forall z Z, tau <= Z -> Z <= z -> Z * (1 - 2 * u) <= rnd z.
Proof.
  intros z Z HZ Hz. generalize (rnd_any z) tau_pos u_pos u_val. intros H T0 U0 Hu.
  rewrite (Rabs_pos_eq z) in H by lra. apply Rabs_le_inv in H.
  assert (Z * (1 - u) <= z * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact Hz]).
  assert (u * tau <= u * Z) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma rnd_mult_lower : forall x y X Y, 0 <= X -> 0 <= Y -> tau <= X * Y -> X <= x -> Y <= y ->
  X * Y * (1 - 2 * u) <= rnd (x * y).
Proof. intros. apply rnd_lower; auto. apply Rmult_le_compat; auto. Qed.
Lemma guarded : forall n, smallest_norm <= n -> / 10 ^ 43 <= n.
Proof. intros n H. eapply Rle_trans; [|exact H]. unfold smallest_norm. rewrite u_val. lra. Qed.
