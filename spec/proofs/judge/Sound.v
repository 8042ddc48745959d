(* What the judge takes as proved is right, as the specification defines it: judge_sound. Before it come distances, and
   numbers that are claimed as ratios. *)
From Coq Require Import Reals ZArith Lra Lia List Bool Sorted.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.CriticalPoint spec.StationaryPoint.
From Flowcert Require Import judge.Judge judge.Dimension judge.Rows judge.Faces.
Import ListNotations.
Open Scope R_scope.

(* ---- Numbers that are claimed ---- *)

Lemma ratio_right : forall a n w e, (0 < w)%Z -> ratio_checked a n w e = true ->
  is_ratio a (unit_of e * IZR n / IZR w).
Proof.
  intros a n w e Hw H. unfold ratio_checked in H. rewrite andb_true_iff, Z.ltb_lt, Z.eqb_eq in H.
  destruct H as [D E]. split; auto. apply IZR_lt in Hw. apply IZR_lt in D.
  apply (f_equal IZR) in E. rewrite !mult_IZR, !unit_integer in E by lia.
  assert (U : unit_of (Z.max 0 e) = unit_of e * unit_of (Z.max 0 (- e))).
  { rewrite <- unit_add. f_equal. lia. }
  rewrite U in E. assert (P := unit_positive (Z.max 0 (- e))). set (u := unit_of (Z.max 0 (- e))) in *.
  assert (F : IZR (numerator a) * IZR w = IZR (denominator a) * IZR n * unit_of e).
  { apply Rmult_eq_reg_r with u; [rewrite E; ring | lra]. }
  apply Rmult_eq_reg_r with (IZR w); [|lra]. apply Rmult_eq_reg_r with (IZR (denominator a)); [|lra].
  transitivity (IZR (numerator a) * IZR w); [field; lra|]. rewrite F. field. lra.
Qed.

Lemma center_right : forall W c g position, (0 < W)%Z -> center_checked W c g position = true ->
  has_center (center_at (unit_of g) W c) position.
Proof.
  intros W c g [[[a b] d]|] HW H; [|exact I]. simpl in H. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  assert (E : forall u, unit_of g / IZR W * u = unit_of g * u / IZR W) by (intro; unfold Rdiv; ring).
  simpl. rewrite !E. split; [|split]; apply ratio_right; auto.
Qed.

(* ---- Distances ---- *)

Lemma nearness_right : forall s W c p, (0 < W)%Z -> lift p = zdot (at_grid p) (at_grid p) ->
  dist2 (center_at s W c) (scaled s (at_grid p)) =
  s * s / IZR W * (IZR (nearness W (zscale 2 c) p) + dot (emb c) (emb c) / IZR W).
Proof.
  intros s W c p HW HL. apply IZR_lt in HW. unfold nearness. rewrite HL, minus_IZR, mult_IZR, !emb_dot, emb_scale.
  unfold dist2, center_at, scaled. destruct (emb c) as [c1 c2 c3], (emb (at_grid p)) as [p1 p2 p3].
  unfold dot, vsub, vscale; cbn [vx vy vz]. field. lra.
Qed.

Lemma distance_at_grid : forall s W c p, (0 < W)%Z ->
  dist2 (center_at s W c) (scaled s p) = s * s * IZR (zdist2 (zscale W p) c) / IZR (W * W).
Proof.
  intros s W c p HW. apply IZR_lt in HW. unfold zdist2. rewrite emb_dot, emb_sub, emb_scale, mult_IZR.
  unfold dist2, center_at, scaled. destruct (emb c) as [c1 c2 c3], (emb p) as [p1 p2 p3].
  unfold dot, vsub, vscale; cbn [vx vy vz]. field. lra.
Qed.

Lemma scaled_eq : forall s a b, 0 < s -> scaled s a = scaled s b -> a = b.
Proof.
  intros s [a1 a2 a3] [b1 b2 b3] Hs H. unfold scaled, emb, vscale in H; simpl in H. injection H; intros.
  f_equal; apply eq_IZR; apply Rmult_eq_reg_l with s; lra.
Qed.

Lemma nth_error_map_inv : forall (A B : Type) (f : A -> B) l j y, nth_error (map f l) j = Some y ->
  exists x, nth_error l j = Some x /\ f x = y.
Proof.
  induction l as [|a l IH]; intros [|j] y H; simpl in *; try discriminate.
  - injection H; intro. exists a; auto.
  - apply IH; auto.
Qed.

Section Contact.
Variables (s : R) (W : Z) (c : zvec) (P : list place) (K : list Z) (r : Z).
Hypothesis unit_s : 0 < s.
Hypothesis positive_W : (0 < W)%Z.
Hypothesis lifts : forall p, In p P -> lift p = zdot (at_grid p) (at_grid p).
Hypothesis scanned : scan W (zscale 2 c) r P 0 K [] = true.
Hypothesis some_contact : K <> [].

Let x := center_at s W c.
Let near := nearness W (zscale 2 c).
Let all := map (fun p => scaled s (at_grid p)) P.

Lemma scanned_place : forall j p, nth_error P j = Some p ->
  In (Z.of_nat j) K /\ near p = r /\ ~ earlier P 0 K [] j (at_grid p) \/
  ~ In (Z.of_nat j) K /\ ((r < near p)%Z \/ near p = r /\ earlier P 0 K [] j (at_grid p)).
Proof. destruct (scan_spec _ _ _ _ _ _ _ scanned) as [_ [_ H]]. exact H. Qed.

Lemma first_contact : exists p, In p P /\ near p = r.
Proof.
  destruct (scan_spec _ _ _ _ _ _ _ scanned) as [_ [H _]].
  assert (Some_k : exists k, In k K).
  { clear - some_contact. destruct K as [|k K']; [contradiction|]. exists k. left. auto. }
  destruct Some_k as [k Hk]. assert (B := H k Hk).
  destruct (nth_error P (Z.to_nat k)) as [p|] eqn:E; [|apply nth_error_None in E; lia].
  exists p. split; [eapply nth_error_In; eauto|]. destruct (scanned_place _ _ E) as [[_ [N _]]|[N _]]; [auto|].
  exfalso. apply N. rewrite Z2Nat.id by lia. auto.
Qed.

Lemma near_order : forall p q, In p P -> In q P ->
  (dist2 x (scaled s (at_grid p)) <= dist2 x (scaled s (at_grid q)) <-> (near p <= near q)%Z).
Proof.
  intros p q Hp Hq. unfold x. rewrite !nearness_right by auto. fold (near p) (near q).
  assert (WR : 0 < IZR W) by (apply IZR_lt; auto).
  assert (F : 0 < s * s / IZR W) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; auto | auto]). split.
  - intros H. apply Rmult_le_reg_l in H; auto. apply le_IZR. lra.
  - intros H. apply IZR_le in H. apply Rmult_le_compat_l; lra.
Qed.

Lemma nearest_places : forall p, In p P -> (nearest all x (scaled s (at_grid p)) <-> near p = r).
Proof.
  assert (Low : forall q, In q P -> (r <= near q)%Z).
  { intros q Hq. apply In_nth_error in Hq. destruct Hq as [j Hj].
    destruct (scanned_place _ _ Hj) as [[_ [N _]]|[_ [N|[N _]]]]; lia. }
  intros p Hp. unfold nearest, all. split.
  - intros [_ N]. destruct first_contact as [q [Hq Eq]].
    assert (H := N _ (in_map (fun p => scaled s (at_grid p)) _ _ Hq)). simpl in H. apply near_order in H; auto.
    specialize (Low p Hp). lia.
  - intros E. split; [apply (in_map (fun p => scaled s (at_grid p))); auto|]. intros y Hy. apply in_map_iff in Hy.
    destruct Hy as [q [<- Hq]]. apply near_order; auto. rewrite E. auto.
Qed.

Lemma named_iff_nearest : forall i, In i K <-> exists p, class_name all i p /\ nearest all x p.
Proof.
  destruct (scan_spec _ _ _ _ _ _ _ scanned) as [_ [Range _]].
  intros i. split.
  - intros Hi. assert (B := Range i Hi).
    destruct (nth_error P (Z.to_nat i)) as [p|] eqn:E; [|apply nth_error_None in E; lia].
    assert (Hp : In p P) by (eapply nth_error_In; eauto).
    assert (Hi' : In (Z.of_nat (Z.to_nat i)) K) by (rewrite Z2Nat.id by lia; auto).
    destruct (scanned_place _ _ E) as [[_ [N F]]|[N _]]; [|contradiction].
    exists (scaled s (at_grid p)). split; [|apply nearest_places; auto].
    split; [split; [lia | apply (map_nth_error (fun p => scaled s (at_grid p))); auto]|].
    intros j [Hj Ej]. apply nth_error_map_inv in Ej. destruct Ej as [q [Eq Es]]. apply scaled_eq in Es; auto.
    destruct (Z_le_gt_dec i j) as [|G]; auto. exfalso. apply F. right.
    assert (Hq : In q P) by (eapply nth_error_In; eauto).
    assert (Nq : near q = r).
    { apply nearest_places; auto. rewrite Es. apply nearest_places; auto. }
    destruct (scanned_place _ _ Eq) as [[J _]|[_ [J|[_ [[]|[j' [p' [J1 [J2 [J3 J4]]]]]]]]]]; [|lia|].
    + exists (Z.to_nat j), q. split; [lia|]. auto.
    + exists j', p'. split; [lia|]. split; auto. split; auto. congruence.
  - intros [p [[[Hi E] Least] Near]]. apply nth_error_map_inv in E. destruct E as [q [Eq <-]].
    apply nearest_places in Near; [|eapply nth_error_In; eauto].
    destruct (scanned_place _ _ Eq) as [[J _]|[_ [J|[_ [[]|[j' [p' [J1 [J2 [J3 J4]]]]]]]]]].
    + rewrite Z2Nat.id in J by lia. auto.
    + lia.
    + exfalso. assert (L : (i <= Z.of_nat j')%Z); [|lia]. apply Least. split; [lia|]. rewrite Nat2Z.id.
      rewrite <- J4. apply (map_nth_error (fun p => scaled s (at_grid p))); auto.
Qed.

Lemma scanned_contact_names : forall C, pick P 0 K = Some C -> contact_names all x K (map (scaled s) C).
Proof.
  intros C HC. destruct (scan_spec _ _ _ _ _ _ _ scanned) as [Sorted _].
  split; auto. split; [apply named_iff_nearest|]. apply pick_spec in HC. revert HC.
  assert (Sub : incl K K) by apply incl_refl. revert Sub. generalize K at 1 3 4. intros L. revert C.
  induction L as [|k L IH]; intros C Sub HC; inversion HC as [|? d ? D [B [p [Ep Ed]]] HD]; subst; simpl; constructor.
  - destruct (proj1 (named_iff_nearest k)) as [q [[[_ Eq] Least] _]]; [apply Sub; left; auto|].
    rewrite Z.sub_0_r in Ep. apply (map_nth_error (fun p => scaled s (at_grid p))) in Ep. unfold all in Eq.
    rewrite Ep in Eq. injection Eq; intros <-. split; [split; [lia | auto] | auto].
  - apply IH; auto. intros i Hi. apply Sub. right; auto.
Qed.
End Contact.

(* ---- The judge ---- *)

Lemma prepared_points : forall rows,
  map row_point rows = map (fun p => scaled (unit_of (grid_of rows)) (at_grid p)) (places (prepare rows)).
Proof. intros. rewrite prepared_places, map_map. apply map_ext_in. apply row_on_grid. Qed.

Theorem judge_sound : forall rows q z, judge (prepare rows) q z = Proved -> right (map row_point rows) q.
Proof.
  intros rows q z H. unfold judge in H.
  destruct (pick (places (prepare rows)) 0 (claimed_contact q)) as [[|p0 rest]|] eqn:HP; try discriminate.
  set (C := p0 :: rest) in *. set (W := zsum (weights z)) in *. set (c := zcomb (weights z) C) in *.
  change (grid (prepare rows)) with (grid_of rows) in H. set (s := unit_of (grid_of rows)).
  repeat match type of H with
  | (if negb ?b then _ else _) = _ => destruct b eqn:?; cbn beta iota delta [negb] in H; [|discriminate]
  | (if ?b then _ else _) = _ => destruct b eqn:?; [|discriminate]
  end.
  rewrite andb_true_iff, Z.ltb_lt in Heqb. destruct Heqb as [W0 Fit].
  assert (Hs : 0 < s) by apply unit_positive.
  assert (Lifts : forall p, In p (places (prepare rows)) -> lift p = zdot (at_grid p) (at_grid p)).
  { intros p Hp. rewrite prepared_places in Hp. apply in_map_iff in Hp. destruct Hp as [r [<- _]]. reflexivity. }
  assert (Some_contact : claimed_contact q <> []).
  { intros E. rewrite E in HP. unfold C in HP. destruct (places (prepare rows)); discriminate. }
  assert (Contact := scanned_contact_names s W c _ _ _ Hs W0 Lifts Heqb3 Some_contact C HP).
  rewrite prepared_points. fold s. exists (center_at s W c), (map (scaled s) C). split; [auto|]. split; [|split].
  - eapply kind_right; eauto; reflexivity.
  - apply center_right; auto.
  - unfold distance_checked in Heqb1. destruct (claimed_squared_distance q) as [a|]; [|exact I].
    intros p Near. apply ratio_right in Heqb1; [|nia].
    assert (Near0 : nearest (map (fun p => scaled s (at_grid p)) (places (prepare rows))) (center_at s W c)
                      (scaled s p0)).
    { destruct Contact as [_ [Names All]]. destruct (claimed_contact q) as [|k K]; [contradiction|].
      destruct (proj1 (Names k) (or_introl eq_refl)) as [y [Hy Ny]].
      inversion All as [|? ? ? ? [[_ E1] _] _]; subst. destruct Hy as [[_ E2] _].
      rewrite E1 in E2. injection E2; intros ->. auto. }
    replace (dist2 (center_at s W c) p) with (dist2 (center_at s W c) (scaled s p0)).
    + rewrite distance_at_grid by auto. replace (s * s) with (unit_of (2 * grid_of rows)); [auto|].
      unfold s. rewrite <- unit_add. f_equal. lia.
    + apply Rle_antisym; [apply Near0, Near | apply Near, Near0].
Qed.
