(* The direction behind a facet on doubles: where direction_behind() of src/flow/kernels/direction_across.h says that it
   is known, it is, if what it is given is as near to the exact passage as the code computes that. `behind_right` puts
   together what is proved on real numbers with the values of doubles. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts
  filters.CrossingVectors filters.CrossingSizes filters.CrossingKnown filters.CrossingTerms filters.CrossingOnDoubles.
Open Scope R_scope.

Definition crossing_needs : Q := 365 # 10.
Definition angle_form_needs : Q := 16 # 10.
Definition exit_needs : Q := 193 # 10.
Lemma rule_of_crossings : Qle_bool 6 (units_of kTangentBehind) && Qle_bool (units_of kTangentBehind) 8 = true.
Proof. vm_compute. reflexivity. Qed.

Lemma choose_yes : forall x a b c d, holds x a b -> on_doubles x (Choose Less a b c d) = on_doubles x c.
Proof. intros x a b c d H. unfold holds in H. cbn [on_doubles]. rewrite H. reflexivity. Qed.
Lemma choose_no : forall x a b c d, fails x a b -> on_doubles x (Choose Less a b c d) = on_doubles x d.
Proof. intros x a b c d H. unfold fails in H. cbn [on_doubles]. rewrite H. reflexivity. Qed.
Lemma holds_on_reals : forall x a b, finite (on_doubles x a) -> finite (on_doubles x b) -> holds x a b ->
  val (on_doubles x a) < val (on_doubles x b).
Proof.
  intros x a b Fa Fb H. unfold holds in H. rewrite compare_finite in H by assumption. cbn [compare_reals] in H.
  revert H. case Rlt_bool_spec; [auto | discriminate].
Qed.
Lemma neg_parts : forall x a, (finite (on_doubles x a) -> finite (on_doubles x (Neg a))) /\
  val (on_doubles x (Neg a)) = - val (on_doubles x a).
Proof.
  intros x a. cbn [on_doubles]. unfold finite, val. rewrite is_finite_Bopp. split; [auto | apply B2R_Bopp].
Qed.

Lemma bound_of_approach : forall x, finite (x 3%nat) -> 0 <= val (x 3%nat) <= 3 / 32 ->
  square_in_range x seen_square_size -> finite (on_doubles x approach_bound_behind) /\
  val (on_doubles x approach_bound_behind) =
  rnd (rnd (val (x 3%nat) + val (on_doubles x (times_roundoff kExitBound))) * rnd (sqrt (val (x 10%nat)))).
Proof.
  intros x F3 B3 R. destruct (square_range_back x _ R) as [F10 B10].
  change (on_doubles x seen_square_size) with (x 10%nat) in *.
  assert (P10 : 0 < val (x 10%nat)) by lra. destruct (root_forward (x 10%nat) F10 P10) as [Fr Er].
  destruct (header_times_roundoff kExitBound exit_needs 1000 eq_refl x) as [Fc Hc].
  replace (Q2R exit_needs) with 19.3 in Hc by (unfold Q2R; cbn; lra).
  replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
  set (s n := match n with 0%nat => old_error | 1%nat => times_roundoff kExitBound | _ => Root seen_square_size end).
  change approach_bound_behind with (replace s (Mul (Add (Var 0) (Var 1)) (Var 2))). rewrite on_doubles_replace.
  set (w n := on_doubles x (s n)).
  assert (W0 : w 0%nat = x 3%nat) by reflexivity.
  assert (W1 : w 1%nat = on_doubles x (times_roundoff kExitBound)) by reflexivity.
  assert (W2 : w 2%nat = Bsqrt mode_NE (x 10%nat)) by reflexivity.
  destruct (forward w (fun n => match n with 0%nat | 1%nat => 0 | 2%nat => 88 | _ => 5000 end)%Z
    (Mul (Add (Var 0) (Var 1)) (Var 2)) 89) as [F [E _]].
  - generalize u_pos u_val. intros U0 Hu. assert (One : bpow radix2 0 = 1) by reflexivity.
    intros [|[|[|n]]] Hn; [| | |discriminate Hn].
    + rewrite W0, One. split; [exact F3|]. rewrite Rabs_pos_eq; lra.
    + rewrite W1, One. split; [exact Fc|]. rewrite Rabs_pos_eq; rewrite Hu in *; lra.
    + rewrite W2. split; [exact Fr|]. rewrite Er. apply rnd_power; [lia|]. rewrite Rabs_pos_eq by apply sqrt_pos.
      rewrite <- (sqrt_square (bpow radix2 88)) by apply bpow_ge_0. apply sqrt_le_1_alt.
      apply Rle_trans with (10 ^ 50 * 2); [lra|]. rewrite <- bpow_plus. change (bpow radix2 (88 + 88)) with (IZR (2 ^
      176)). rewrite pow_IZR, <- mult_IZR. apply IZR_le. apply Z.leb_le. vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - split; [exact F|]. rewrite E. unfold rounded. cbn [on_reals]. rewrite W0, W1, W2, Er. reflexivity.
Qed.

Section Behind.
Variables (x : nat -> double) (p0 p1 q k0 k1 c0 : vec) (d L : R).
Let X n := val (x n).
Let U := value_of_vector X 0.
Let nc := value_of_vector X 7.
Let all_finite := forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n).

(* What a passage is given as. The height may be computed from more than these. *)
Record good_passage : Prop := GoodPassage {
  has_circle_of_corners : polygon p0 p1 q k0 k1 c0;
  size_not_negative : not_negative (x 16%nat);
  ratio_not_negative : not_negative (x 17%nat);
  inputs_are_near : all_finite -> square_in_range x seen_square_size ->
    way_inputs p0 p1 q k0 k1 U (value_of_vector X 2) (value_of_vector X 4) (X 9%nat) (X 10%nat) d L (X 16%nat);
  next_edge_is_near : square_in_range x (square 7) -> len (vsub nc (vsub k1 k0)) <= u * len (vsub k1 k0) /\
    / 10 ^ 26 <= len (vsub k1 k0) <= 10 ^ 26;
  height_is_enough : all_finite -> square_in_range x seen_square_size -> square_in_range x (square 6) ->
    square_in_range x (square 7) -> L * L * (1 - 14 * u) <= X 16%nat ->
    L <= 10 ^ 14 * len (vsub q p0) -> L <= 10 ^ 14 * len (vsub q p1) -> height_value x <= 10 ^ 30 * (L * L) ->
    corner_height p0 p1 q k0 k1 c0 * (1 - 20 * u) <= height_value x }.

Variables (y : vec) (sigma : R).
Definition way_of_sign := (sigma = 1 \/ sigma = -1) /\
  ((0 < sigma * dot y (bisector_g p0 p1 q) /\ 0 <= sigma * h p0 p1 q) \/
   (0 <= sigma * dot y (bisector_g p0 p1 q) /\ 0 < sigma * h p0 p1 q)).

Theorem behind_right : good_passage -> (forall k, (k < 4)%nat -> finite (x k)) ->
  known (vsub p1 p0) y U (X 3%nat) -> way_of_sign -> run x Code.Behind.is_known = Some Positive ->
  (forall t, In t (Code.Behind.u_x :: Code.Behind.u_y :: Code.Behind.u_z :: Code.Behind.error :: nil) ->
    finite (on_doubles x t)) /\
  known (vsub k1 k0) (vscale sigma (step p0 p1 q y k0 k1))
    (V (val (on_doubles x Code.Behind.u_x)) (val (on_doubles x Code.Behind.u_y)) (val (on_doubles x Code.Behind.u_z)))
    (val (on_doubles x Code.Behind.error)).
Proof.
  intros [Poly Ns Nr Inputs Next Height] Fx K [Sigma Way] Run. generalize u_pos u_val. intros U0 Hu.
  destruct (error_is_small _ _ _ _ K) as [t1 t2]. set (t := X 3%nat) in *.
  destruct behind_match as [Mx [My [Mz [Me _]]]].
  destruct (behind_tests x Run) as [R10 [R6 [R7 [_ [_ Certain]]]]].
  assert (t0 : 0 < t) by lra. assert (t01 : 0 <= t <= 1) by lra.
  destruct (values_are_right x Fx (conj t0 t2) Ns Nr Run)
    as [Fall B10 _ [_ [Fnn Enn]] [FA EA] [Fy EY] HighY [Fi [Ei Pi]] [Fab Eab] Hh Small [Fe Ee]].
  fold X in B10, Enn, EA, EY, HighY, Ei, Pi, Eab, Small, Ee.
  set (gc := value_of_vector X 2) in *. set (Dc := value_of_vector X 4) in *.
  fold U nc t in EA, EY, HighY, Ei, Pi, Small, Ee, Enn.
  assert (In := Inputs Fall R10). destruct (Next R7) as [Near Edge].
  (* constants *)
  destruct (header_times_roundoff kCrossingBound crossing_needs 1000 eq_refl x) as [_ [Hc _]].
  replace (Q2R crossing_needs) with 36.5 in Hc by (unfold Q2R; cbn; lra).
  destruct (header_times_roundoff kAngleFormBound angle_form_needs 1000 eq_refl x) as [_ [Hc2 _]].
  replace (Q2R angle_form_needs) with 1.6 in Hc2 by (unfold Q2R; cbn; lra).
  destruct (header_times_roundoff kExitBound exit_needs 1000 eq_refl x) as [_ Hce].
  replace (Q2R exit_needs) with 19.3 in Hce by (unfold Q2R; cbn; lra).
  replace (Q2R 1000) with 1000 in Hce by (unfold Q2R; cbn; lra).
  assert (HB := rule_of_crossings). rewrite andb_true_iff, !Qle_bool_iff in HB. destruct HB as [HB1 HB2].
  apply Qle_Rle in HB1, HB2. unfold units_of in HB1, HB2. rewrite rational_value in HB1, HB2.
  replace (Q2R 6) with 6 in HB1 by (unfold Q2R; cbn; lra). replace (Q2R 8) with 8 in HB2 by (unfold Q2R; cbn; lra).
  set (c := val (on_doubles x (times_roundoff kCrossingBound))) in *.
  set (c2 := val (on_doubles x (times_roundoff kAngleFormBound))) in *.
  set (ce := val (on_doubles x (times_roundoff kExitBound))) in *.
  set (kB := F2R (Float radix2 (fst kTangentBehind) (snd kTangentBehind))) in *.
  set (height := height_value x) in *. destruct Hh as [_ Hh].
  (* on real numbers *)
  destruct (crossing_sizes _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ In K t1 Hc Hc2 Hh HighY Pi Small)
    as [_ [L1 [L2 [_ [_ Top]]]]].
  assert (Enough := Height Fall R10 R6 R7 (way_square _ _ _ _ _ _ _ _ _ _ _ _ _ In) L1 L2 Top).
  destruct (bound_of_slack _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ In Hc Hc2 Hh t01 Pi Small)
    as [_ [_ [_ [_ [_ [Small_r _]]]]]].
  destruct (crossing_flat _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Poly In K Hc HighY Pi Small_r) as [LowY [Unit Flat]].
  assert (Fnc : fmt3 nc) by (repeat split; apply fmt_val).
  destruct (crossing_known _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Poly In K Hc Hc2 (conj HB1 HB2) Fnc Near Edge
    Enough HighY Pi Small Sigma) as [_ Known].
  (* the sign *)
  destruct (bound_of_approach x (Fx 3%nat ltac:(lia)) ltac:(change (val (x 3%nat)) with t; lra) R10) as [Fb Eb].
  change (val (x 3%nat)) with t in Eb. fold ce in Eb.
  destruct (sign_of_way_right _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ In K Hc2 Hce (fmt_val _) (fmt_val _) Sigma Way)
    as [Plus Minus].
  assert (Fh : finite (on_doubles x angle_form)) by (apply (Fall 9%nat); lia).
  change (val (x 9%nat)) with (X 9%nat) in Ei, Pi. set (i := way_inverse (way_vector U gc (X 9%nat) Dc)) in *.
  assert (Factor : finite (on_doubles x factor_behind) /\ val (on_doubles x factor_behind) = sigma * i).
  { unfold factor_behind. destruct Certain as [H|[[N H]|[[N [N2 H]]|[N [N2 H]]]]].
    - rewrite (choose_yes _ _ _ _ _ H). apply (holds_on_reals _ _ _ Fb FA) in H. rewrite Eb, EA in H.
      rewrite (Plus (or_introl H)). split; [exact Fi|]. rewrite Ei. ring.
    - rewrite (choose_no _ _ _ _ _ N), (choose_yes _ _ _ _ _ H). apply (holds_on_reals _ _ _ Fab Fh) in H.
      rewrite Eab in H. rewrite (Plus (or_intror H)). split; [exact Fi|]. rewrite Ei. ring.
    - rewrite (choose_no _ _ _ _ _ N), (choose_no _ _ _ _ _ N2).
      destruct (neg_parts x approach_bound_behind) as [Fn En]. apply (holds_on_reals _ _ _ FA (Fn Fb)) in H.
      rewrite En, Eb, EA in H. rewrite (Minus (or_introl H)). destruct (neg_parts x inverse_behind) as [Fn' En'].
      split; [exact (Fn' Fi)|]. rewrite En', Ei. ring.
    - rewrite (choose_no _ _ _ _ _ N), (choose_no _ _ _ _ _ N2).
      destruct (neg_parts x angle_form_bound) as [Fn En]. apply (holds_on_reals _ _ _ Fh (Fn Fab)) in H.
      rewrite En, Eab in H. rewrite (Minus (or_intror H)). destruct (neg_parts x inverse_behind) as [Fn' En'].
      split; [exact (Fn' Fi)|]. rewrite En', Ei. ring. }
  destruct Factor as [Ff Ef].
  (* the coordinates *)
  set (s n := match n with 0%nat | 1%nat | 2%nat => part_behind n | _ => Var (18 + n) end).
  set (w n := on_doubles x (s n)).
  assert (Coordinate : forall j, (j < 3)%nat -> on_doubles x (coordinate_behind j) =
    Bmult mode_NE (on_doubles x factor_behind) (on_doubles w (Sub (Var j) (Mul along_edge (Var (3 + j)))))).
  { assert (C : forall e, on_doubles x (Mul factor_behind (replace s e)) =
      Bmult mode_NE (on_doubles x factor_behind) (on_doubles w e)).
    { intro e. unfold w. rewrite <- on_doubles_replace. reflexivity. }
    intros [|[|[|j]]] Hj; [| | |lia].
    - exact (C (Sub (Var 0) (Mul along_edge (Var 3)))).
    - exact (C (Sub (Var 1) (Mul along_edge (Var 4)))).
    - exact (C (Sub (Var 2) (Mul along_edge (Var 5)))). }
  assert (Square : on_doubles w (square 1) = on_doubles x (square 7)).
  { unfold w. rewrite <- on_doubles_replace. reflexivity. }
  assert (Wy : value_of_vector (fun n => val (w n)) 0 = way_vector U gc (X 9%nat) Dc) by exact EY.
  assert (Wn : value_of_vector (fun n => val (w n)) 1 = nc) by reflexivity.
  destruct (shortened_on_doubles (vsub k1 k0) w (on_doubles x factor_behind) i) as [Coord Value].
  - intros [|[|[|j]]] Hj; [exact (Fy 0%nat Hj) | exact (Fy 1%nat Hj) | exact (Fy 2%nat Hj) | lia].
  - intros j Hj. change (finite (x (18 + (3 + j))%nat)). apply Fall; lia.
  - rewrite Square. exact Fnn.
  - rewrite Wn. exact Near.
  - exact Edge.
  - rewrite Wy. exact (conj LowY HighY).
  - rewrite Wy. exact Unit.
  - rewrite Wy. exact Flat.
  - exact Ff.
  - rewrite Ef, Rabs_mult, (Rabs_pos_eq i) by lra. destruct Sigma as [-> | ->]; [rewrite Rabs_R1 | rewrite Rabs_left by
      lra]; ring.
  - rewrite Wy, Wn, Ef in Value. rewrite Mx, My, Mz, Me. split.
    + intros z [<-|[<-|[<-|[<-|[]]]]].
      * rewrite (Coordinate 0%nat) by lia. apply (Coord 0%nat). lia.
      * rewrite (Coordinate 1%nat) by lia. apply (Coord 1%nat). lia.
      * rewrite (Coordinate 2%nat) by lia. apply (Coord 2%nat). lia.
      * exact Fe.
    + rewrite !Coordinate by lia. rewrite Value, Ee. exact Known.
Qed.
End Behind.
