(* Stationary points (FC-CRIT-01, FC-CRIT-03 to 06).
   P is the merged input, K a list of ids, and C has the points of K. *)
From Coq Require Import Reals ZArith Lra Lia List FinFun.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint spec.Dimension spec.Face.
Import ListNotations.
Open Scope R_scope.

Definition stationary P x K := contact_set P x K /\ exists C, Forall2 (point_at P) K C /\ in_conv C x.
Definition is_stationary P x := exists K, stationary P x K.
Definition regular P x K := stationary P x K /\ forall k, ~ critical P x K k.
Definition kind P x K i k :=
  stationary P x K /\
  exists C F, Forall2 (point_at P) K C /\ face C F /\ in_relint F x /\ affine_dimension F i /\ affine_dimension C k.

(* ---- Contact sets, as ids and as points ---- *)

Lemma points_unique : forall P K C D, Forall2 (point_at P) K C -> Forall2 (point_at P) K D -> C = D.
Proof.
  intros P K C D H. revert D. induction H as [|i p K C [_ Hp] H IH]; intros D HD; inversion HD; subst; auto.
  destruct H2 as [_ H2]. f_equal; [congruence | auto].
Qed.
Lemma point_of_id : forall P K C i, Forall2 (point_at P) K C -> In i K -> exists p, In p C /\ point_at P i p.
Proof.
  intros P K C i H. induction H as [|j p K C Hp H IH]; intros []; [subst; exists p; split; [left|]; auto|].
  destruct IH as [q [Hq Eq]]; auto. exists q. split; [right|]; auto.
Qed.
Lemma id_of_point : forall P K C p, Forall2 (point_at P) K C -> In p C -> exists i, In i K /\ point_at P i p.
Proof.
  intros P K C p H. induction H as [|j q K C Hq H IH]; intros []; [subst; exists j; split; [left|]; auto|].
  destruct IH as [i [Hi Ei]]; auto. exists i. split; [right|]; auto.
Qed.
Lemma point_at_in : forall P i p, point_at P i p -> In p P.
Proof. intros P i p [_ H]. apply nth_error_In in H. exact H. Qed.
Lemma point_at_exists : forall P p, In p P -> exists i, point_at P i p.
Proof.
  intros P p H. apply In_nth_error in H. destruct H as [n H]. exists (Z.of_nat n). split; [lia|].
  rewrite Nat2Z.id. exact H.
Qed.
Lemma point_at_same : forall P i p q, point_at P i p -> point_at P i q -> p = q.
Proof. intros P i p q [_ H] [_ H']. congruence. Qed.
Lemma point_at_once : forall P i j p, NoDup P -> point_at P i p -> point_at P j p -> i = j.
Proof.
  intros P i j p D [Hi Ei] [Hj Ej]. apply Z2Nat.inj; auto. apply (NoDup_nth_error P); auto; [|congruence].
  apply nth_error_Some. congruence.
Qed.

Theorem contact_set_exists : forall P x, exists K, contact_set P x K.
Proof.
  intros P x.
  set (near p := if Forall_dec (fun q => dist2 x p <= dist2 x q) (fun q => Rle_dec _ _) P then true else false).
  set (is_near i := match nth_error P (Z.to_nat i) with Some p => near p | None => false end).
  exists (filter is_near (map Z.of_nat (seq 0 (length P)))). split.
  - apply NoDup_filter, Injective_map_NoDup; [intros a b; apply Nat2Z.inj | apply seq_NoDup].
  - intros i. rewrite filter_In, in_map_iff. unfold is_near, is_contact, point_at. split.
    + intros [[n [<- Hn]] H]. rewrite Nat2Z.id in *. destruct (nth_error P n) as [p|] eqn:E; [|discriminate].
      exists p. split; [split; [lia | auto]|]. unfold near in H.
      destruct (Forall_dec _ _ P) as [F|]; [|discriminate]. rewrite Forall_forall in F. exact F.
    + intros [p [[Hi E] F]]. rewrite E. split.
      * exists (Z.to_nat i). split; [lia|]. apply in_seq. split; [lia|]. apply nth_error_Some. congruence.
      * unfold near. destruct (Forall_dec _ _ P) as [|N]; auto. exfalso. apply N, Forall_forall, F.
Qed.
Lemma contact_points_exist : forall P x K, contact_set P x K -> exists C, Forall2 (point_at P) K C.
Proof.
  intros P x K [_ H]. assert (G : forall i, In i K -> exists p, point_at P i p).
  { intros i Hi. apply H in Hi. destruct Hi as [p [Hp _]]. exists p. auto. }
  clear H. induction K as [|i K IH]; [exists []; constructor|].
  destruct IH as [C HC]; [intros; apply G; right; auto|].
  destruct (G i (or_introl eq_refl)) as [p Hp]. exists (p :: C). constructor; auto.
Qed.
Lemma contact_points : forall P x K C, contact_set P x K -> Forall2 (point_at P) K C ->
  forall p, In p C <-> nearest P x p.
Proof.
  intros P x K C [_ H] HC p. split.
  - intros Hp. destruct (id_of_point P K C p HC Hp) as [i [Hi Ei]]. apply H in Hi.
    destruct Hi as [q [Eq N]]. rewrite (point_at_same P i p q) by auto. split; auto. apply point_at_in in Eq. auto.
  - intros [Hp N]. destruct (point_at_exists P p Hp) as [i Ei].
    assert (Hi : In i K) by (apply H; exists p; auto).
    destruct (point_of_id P K C i HC Hi) as [q [Hq Eq]]. rewrite (point_at_same P i p q); auto.
Qed.
(* So the ids are not needed: a stationary point is in the hull of samples that are nearest to it. *)
Lemma stationary_iff_nearest : forall P x, is_stationary P x <->
  exists C, (forall p, In p C -> nearest P x p) /\ in_conv C x.
Proof.
  intros P x. split.
  - intros [K [HK [C [F Hx]]]]. exists C. split; auto. intros p. apply (contact_points P x K C HK F).
  - intros [C [HC Hx]]. destruct (contact_set_exists P x) as [K HK]. destruct (contact_points_exist P x K HK) as [D F].
    exists K. split; auto. exists D. split; auto. apply (conv_incl C); auto.
    intros p Hp. apply (contact_points P x K D HK F); auto.
Qed.
(* All points of a contact set are at one distance. *)
Lemma contact_distance : forall P x K C p q, contact_set P x K -> Forall2 (point_at P) K C -> In p C -> In q C ->
  dist2 x p = dist2 x q.
Proof.
  intros P x K C p q H HC Hp Hq. apply (contact_points P x K C H HC) in Hp, Hq.
  destruct Hp as [Ip Np], Hq as [Iq Nq]. apply Rle_antisym; auto.
Qed.
(* The contact set is a function of the position. *)
Lemma contact_set_same : forall P x K L, contact_set P x K -> contact_set P x L -> forall i, In i K <-> In i L.
Proof. intros P x K L [_ H] [_ H'] i. rewrite H, H'. reflexivity. Qed.

Lemma hull_nonempty : forall C x, in_conv C x -> exists p, In p C.
Proof.
  intros [|p C] x [w [L [_ [S _]]]]; [destruct w; simpl in *; [lra | discriminate] | exists p; left; auto].
Qed.
Lemma critical_iff_relint : forall P x K C, contact_set P x K -> Forall2 (point_at P) K C ->
  ((exists k, critical P x K k) <-> in_relint C x).
Proof.
  intros P x K C H HC. split.
  - intros [k [_ [D [HD [R _]]]]]. rewrite (points_unique P K C D); auto.
  - intros R. destruct (hull_nonempty C x (proj1 R)) as [p Hp].
    destruct (affine_dimension_exists C p Hp) as [k Hk]. exists k. split; auto. exists C. auto.
Qed.

(* ---- FC-CRIT-04 ---- *)

Theorem critical_of_index_0 : forall P x K, NoDup P ->
  (critical P x K 0 <-> exists i, point_at P i x /\ K = [i]).
Proof.
  intros P x K D. split.
  - intros [H [C [HC [[X _] Z]]]]. destruct (hull_nonempty C x X) as [p Hp].
    assert (E : forall q, In q C -> q = p) by (intros q Hq; apply (affine_dimension_0 C); auto).
    assert (Ex : x = p).
    { destruct X as [w [L [_ [S <-]]]]. clear - E L S. transitivity (vscale (sum w) p);
        [|rewrite S; apply vec_eq; simpl; ring]. clear S. revert w L.
      induction C as [|q C IH]; intros [|a w] L; try discriminate; simpl.
      - apply vec_eq; simpl; ring.
      - rewrite IH by (auto; intros; apply E; right; auto). rewrite (E q) by (left; auto). apply vec_eq; simpl; ring. }
    subst p. destruct (id_of_point P K C x HC Hp) as [i [Hi Ei]]. exists i. split; auto.
    assert (U : forall j, In j K -> j = i).
    { intros j Hj. destruct (point_of_id P K C j HC Hj) as [q [Hq Eq]]. rewrite (E q Hq) in Eq.
      apply (point_at_once P j i x); auto. }
    destruct H as [N _]. destruct K as [|a [|b K]]; [destruct Hi | rewrite (U a); simpl; auto |].
    exfalso. inversion N as [|a' K' Na _]; subst. apply Na. left. rewrite (U a), (U b); simpl; auto.
  - intros [i [Ei ->]].
    assert (Z : dist2 x x = 0) by (clear; vdestruct; vunfold; ring).
    assert (Hx : In x P) by (apply (point_at_in P i); auto).
    split.
    + split; [repeat constructor; auto; intros []|]. intros j. split.
      * intros [<-|[]]. exists x. split; auto. intros q _. rewrite Z. apply dot_self_nonneg.
      * intros [q [Eq N]]. left. apply (point_at_once P i j x); auto. replace x with q; auto.
        symmetry. apply dist2_zero. apply Rle_antisym; [rewrite <- Z; auto | apply dot_self_nonneg].
    + exists [x]. split; [repeat constructor; auto; apply Ei|]. split.
      * apply positive_weights_sound. exists [1]. repeat split; auto; simpl; [repeat constructor; lra | ring |].
        apply vec_eq; simpl; ring.
      * apply (affine_dimension_of_one [x] x); [left; auto|]. intros q [<-|[]]; auto.
Qed.

(* ---- FC-CRIT-06 ---- *)

(* A point of the affine hull that is at one distance from all points is the only one. *)
Lemma centre_unique : forall C x y, in_aff C x -> in_aff C y ->
  (forall p q, In p C -> In q C -> dist2 x p = dist2 x q) -> (forall p q, In p C -> In q C -> dist2 y p = dist2 y q) ->
  x = y.
Proof.
  intros C x y X Y EX EY. destruct C as [|p C].
  - destruct X as [w [L [S _]]]. destruct w; simpl in *; [lra | discriminate].
  - assert (H : forall q, In q (p :: C) -> dot (vsub x y) q = dot (vsub x y) p).
    { intros q Hq. specialize (EX q p Hq (or_introl eq_refl)). specialize (EY q p Hq (or_introl eq_refl)).
      revert EX EY. clear. vdestruct; vunfold. lra. }
    apply (aff_level _ _ _ x H) in X. apply (aff_level _ _ _ y H) in Y. apply dist2_zero.
    transitivity (dot (vsub x y) x - dot (vsub x y) y); [clear; vdestruct; vunfold; ring | lra].
Qed.

Theorem stationary_points_differ : forall P x y K L, stationary P x K -> stationary P y L ->
  (x = y <-> forall i, In i K <-> In i L).
Proof.
  intros P x y K L [HK [C [HC X]]] [HL [D [HD Y]]]. split.
  - intros <-. apply (contact_set_same P x); auto.
  - intros E.
    assert (Sub : incl C D).
    { intros p Hp. destruct (id_of_point P K C p HC Hp) as [i [Hi Ei]]. apply E in Hi.
      destruct (point_of_id P L D i HD Hi) as [q [Hq Eq]]. rewrite (point_at_same P i p q); auto. }
    apply (centre_unique D).
    + apply (aff_incl C); auto. apply conv_in_aff; auto.
    + apply conv_in_aff; auto.
    + assert (Back : incl D C).
      { intros p Hp. destruct (id_of_point P L D p HD Hp) as [i [Hi Ei]]. apply E in Hi.
        destruct (point_of_id P K C i HC Hi) as [q [Hq Eq]]. rewrite (point_at_same P i p q); auto. }
      intros p q Hp Hq. apply (contact_distance P x K C); auto.
    + intros p q Hp Hq. apply (contact_distance P y L D); auto.
Qed.

(* ---- FC-CRIT-05 ---- *)

(* The conditions (a) to (d) for the points C with the ids K; r is the squared radius of the sphere. *)
Definition sphere_conditions P K C z r :=
  (in_aff C z /\ forall p, In p C -> dist2 z p = r) /\
  (forall q, In q P -> r <= dist2 z q) /\
  (forall i q, point_at P i q -> dist2 z q = r -> In i K) /\
  in_conv C z.

Lemma conditions_hold : forall P x K C, contact_set P x K -> Forall2 (point_at P) K C -> in_conv C x ->
  exists r, sphere_conditions P K C x r.
Proof.
  intros P x K C H HC X. destruct (hull_nonempty C x X) as [p Hp]. exists (dist2 x p).
  apply (contact_points P x K C H HC) in Hp as Np. destruct Np as [Ip Np].
  split; [split; [apply conv_in_aff; auto|] |].
  - intros q Hq. apply (contact_distance P x K C); auto.
  - split; auto. split; auto. intros i q Eq E. apply H. exists q. split; auto. intros r Hr. rewrite E. auto.
Qed.
Lemma conditions_suffice : forall P z r K C, NoDup K -> Forall2 (point_at P) K C -> sphere_conditions P K C z r ->
  contact_set P z K.
Proof.
  intros P z r K C N HC [[A B] [E [F D]]]. split; auto. intros i. split.
  - intros Hi. destruct (point_of_id P K C i HC Hi) as [p [Hp Ep]]. exists p. split; auto.
    intros q Hq. rewrite (B p Hp). auto.
  - intros [p [Ep Np]]. apply (F i p Ep). destruct (hull_nonempty C z D) as [q Hq]. apply Rle_antisym.
    + rewrite <- (B q Hq). apply Np. destruct (id_of_point P K C q HC Hq) as [j [_ Ej]]. apply point_at_in in Ej. auto.
    + apply E. apply point_at_in in Ep. auto.
Qed.

Theorem contact_set_of_stationary : forall P K C, NoDup K -> Forall2 (point_at P) K C ->
  ((exists x, stationary P x K) <-> exists z r, sphere_conditions P K C z r) /\
  forall z r, sphere_conditions P K C z r ->
    (forall x, stationary P x K <-> x = z) /\ ((exists k, critical P z K k) <-> in_relint C z).
Proof.
  intros P K C N HC.
  assert (S : forall z r, sphere_conditions P K C z r -> stationary P z K).
  { intros z r H. split; [apply (conditions_suffice P z r K C); auto|]. exists C. split; auto. apply H. }
  split; [split|].
  - intros [x [H [D [HD X]]]]. rewrite <- (points_unique P K C D HC HD) in X. exists x.
    apply (conditions_hold P x K C); auto.
  - intros [z [r H]]. exists z. eauto.
  - intros z r H. split.
    + intros x. split; [|intros ->; eauto]. intros X. apply (stationary_points_differ P x z K K); eauto. tauto.
    + apply critical_iff_relint; auto. apply (conditions_suffice P z r K C); auto.
Qed.

(* ---- FC-CRIT-03 ---- *)

Lemma kind_unique : forall P x K i k i' k', kind P x K i k -> kind P x K i' k' -> i = i' /\ k = k'.
Proof.
  intros P x K i k i' k' [_ [C [F [HC [FF [R [DF DC]]]]]]] [_ [C' [F' [HC' [FF' [R' [DF' DC']]]]]]].
  rewrite <- (points_unique P K C C' HC HC') in *. split.
  - assert (E := carrying_face_unique C x F F' FF FF' R R').
    apply Nat.le_antisymm; [apply (affine_dimension_incl F F') | apply (affine_dimension_incl F' F)]; auto;
      intros p Hp; apply E; auto.
  - apply (affine_dimension_unique C); auto.
Qed.

(* There is one kind, and it is one of three. So the face is a proper one. *)
Theorem kinds_of_regular_points : forall P x K, regular P x K ->
  exists i k, kind P x K i k /\ ((i = 1 /\ k = 2) \/ (i = 1 /\ k = 3) \/ (i = 2 /\ k = 3))%nat /\
    forall i' k', kind P x K i' k' -> i' = i /\ k' = k.
Proof.
  intros P x K [[H [C [HC X]]] N].
  destruct (carrying_face C x X) as [F [FF R]]. destruct (hull_nonempty F x (proj1 R)) as [f Hf].
  destruct FF as [FF0 [u [m [B A]]]].
  assert (Sub : incl F C) by (intros p Hp; apply A; auto).
  destruct (affine_dimension_exists F f Hf) as [i Di]. destruct (affine_dimension_exists C f (Sub f Hf)) as [k Dk].
  (* a point of C is not in F *)
  destruct (level_or_off u m C) as [All|[q [Hq Nq]]].
  { exfalso. destruct (proj2 (critical_iff_relint P x K C H HC)) as [k' Hk]; [|apply (N k'), Hk].
    apply (relint_same F); auto. intros p Hp. apply A. auto. }
  assert (Lt : (i < k)%nat).
  { apply (affine_dimension_grows F C i k u m q); auto. intros p Hp. apply A. auto. }
  assert (Le : (k <= 3)%nat) by (apply (affine_dimension_at_most_3 C); auto).
  assert (Pos : (i <> 0)%nat).
  { intros ->. assert (Ef : x = f).
    { apply (centre_unique F).
      - apply conv_in_aff, R.
      - apply conv_in_aff, (conv_incl [f]); [intros p [<-|[]]; auto|]. exists [1]. repeat split; auto; simpl;
          [repeat constructor; lra | ring | apply vec_eq; simpl; ring].
      - intros p p' Hp Hp'. apply (contact_distance P x K C); auto.
      - intros p p' Hp Hp'. rewrite (affine_dimension_0 F p p'); auto. }
    apply Nq. assert (E : x = q).
    { apply dist2_zero. rewrite (contact_distance P x K C q f); auto. rewrite Ef. clear. vdestruct; vunfold; ring. }
    rewrite <- E, Ef. apply A. auto. }
  assert (Here : kind P x K i k).
  { split; [split; [auto | exists C; auto]|]. exists C, F. repeat split; auto; [exists u, m; split; auto | apply R..]. }
  exists i, k. split; [exact Here|]. split; [lia|]. intros i' k' H'. apply (kind_unique P x K); auto.
Qed.
