(* Flow segments (FC-FLOW-01 to 04): how the contact set changes along a ray, the types of segments, and their driver.
   P is the merged input; nearest P x p says that p is in the contact set of x. *)
From Coq Require Import Reals ZArith Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint spec.Dimension spec.Face
  spec.Stationary spec.Driver.
Import ListNotations.
Open Scope R_scope.

Definition along x t u := vadd x (vscale t u).

(* This is K of FC-FLOW-01: it has the points of the contact set of x with the largest product with u. *)
Definition foremost P x u p := nearest P x p /\ forall q, nearest P x q -> dot u q <= dot u p.

(* The contact set of x + t u is K. *)
Definition on_segment P x u t := forall p, nearest P (along x t u) p <-> foremost P x u p.

(* The end is the first point with t > 0 whose contact set is another one. *)
Definition segment_end P x u T := 0 < T /\ (forall t, 0 < t < T -> on_segment P x u t) /\ ~ on_segment P x u T.

(* ---- FC-FLOW-01 ---- *)

(* By how much q is farther than p is an affine function of t. *)
Lemma lead : forall x u t p q,
  dist2 (along x t u) q - dist2 (along x t u) p = (dist2 x q - dist2 x p) - t * (2 * (dot u q - dot u p)).
Proof. intros. unfold along. vdestruct; vunfold; ring. Qed.

Lemma foremost_exists : forall P x u, P <> [] -> exists p, foremost P x u p.
Proof.
  intros P x u H. destruct (contacts_exist P x H) as [C [c [HC Hc]]].
  destruct (least (fun p => - dot u p) C) as [p [Hp L]]; [intros ->; destruct Hc|].
  exists p. split; [apply HC; auto|]. intros q Hq. apply HC, L in Hq. lra.
Qed.

(* A point of K is the nearest one as long as no point has caught up with it, and only those of K are as near. *)
Lemma before_meeting : forall P x u p t, foremost P x u p -> 0 < t ->
  (forall q, In q P -> dot u p < dot u q -> t * (2 * (dot u q - dot u p)) < dist2 x q - dist2 x p) ->
  on_segment P x u t.
Proof.
  intros P x u p t [[Ip Np] Fp] Ht M.
  assert (G : forall q, In q P -> dist2 (along x t u) p <= dist2 (along x t u) q /\
    (dist2 (along x t u) q <= dist2 (along x t u) p -> dist2 x q = dist2 x p /\ dot u q = dot u p)).
  { intros q Hq. specialize (Np q Hq). specialize (M q Hq). assert (E := lead x u t p q).
    destruct (Rlt_dec (dot u p) (dot u q)) as [L|L]; [specialize (M L); split; intros; lra|].
    assert (0 <= t * (2 * (dot u p - dot u q))) by (apply Rmult_le_pos; lra).
    split; [lra|]. intros Le.
    assert (Z : t * (2 * (dot u p - dot u q)) = 0) by lra. apply Rmult_integral in Z. split; [lra|].
    destruct Z; lra. }
  intros q. split.
  - intros [Hq Nq]. destruct (G q Hq) as [_ G']. destruct (G' (Nq p Ip)) as [E E'].
    assert (Cq : nearest P x q) by (split; auto; intros r Hr; rewrite E; auto).
    split; auto. intros r Hr. rewrite E'. auto.
  - intros [[Hq Nq] Fq]. split; auto. intros r Hr. apply Rle_trans with (dist2 (along x t u) p); [|apply G; auto].
    assert (E := lead x u t p q). assert (dist2 x q <= dist2 x p) by auto.
    assert (dot u p <= dot u q) by (apply Fq; split; auto).
    assert (0 <= t * (2 * (dot u q - dot u p))) by (apply Rmult_le_pos; lra). lra.
Qed.

(* None of the points L catches up with p, or one is the first that does so, at the time T. *)
Lemma meeting : forall x u p L,
  (forall q, In q L -> dot u q <= dot u p) \/
  exists T q, In q L /\ dot u p < dot u q /\ dist2 x q - dist2 x p = T * (2 * (dot u q - dot u p)) /\
    forall r, In r L -> dot u p < dot u r -> T * (2 * (dot u r - dot u p)) <= dist2 x r - dist2 x p.
Proof.
  induction L as [|q L IH]; [left; intros q []|].
  assert (Time : forall r, dot u p < dot u r -> dist2 x r - dist2 x p
    = (dist2 x r - dist2 x p) / (2 * (dot u r - dot u p)) * (2 * (dot u r - dot u p))) by (intros; field; lra).
  destruct (Rlt_dec (dot u p) (dot u q)) as [A|A].
  - right. assert (Eq := Time q A). set (S := (dist2 x q - dist2 x p) / _) in *. clearbody S.
    destruct IH as [N|[T [r [Hr [B [E M]]]]]].
    + exists S, q. split; [left; auto|]. repeat split; auto. intros r [<-|Hr] B; [lra|]. apply N in Hr. lra.
    + destruct (Rle_dec S T) as [C|C].
      * exists S, q. split; [left; auto|]. repeat split; auto. intros s [<-|Hs] D; [lra|].
        specialize (M s Hs D). assert (0 <= (T - S) * (2 * (dot u s - dot u p))) by (apply Rmult_le_pos; lra). lra.
      * exists T, r. split; [right; auto|]. repeat split; auto. intros s [<-|Hs] D; [|auto].
        rewrite Eq. assert (0 <= (S - T) * (2 * (dot u q - dot u p))) by (apply Rmult_le_pos; lra). lra.
  - destruct IH as [N|[T [r [Hr [B [E M]]]]]].
    + left. intros r [<-|Hr]; [lra | auto].
    + right. exists T, r. split; [right; auto|]. repeat split; auto. intros s [<-|Hs] D; [contradiction | auto].
Qed.

(* Either no point has a larger product with u than those of K, and the contact set is K for ever. Or the segment ends
   where the first of these points catches up: at the least T with 2 T <u, q - p> = |x - q|^2 - |x - p|^2. *)
Theorem first_meeting : forall P x u p, foremost P x u p ->
  ((forall q, In q P -> dot u q <= dot u p) /\ forall t, 0 < t -> on_segment P x u t) \/
  exists T q, segment_end P x u T /\ In q P /\ dot u p < dot u q /\
    dist2 x q - dist2 x p = T * (2 * (dot u q - dot u p)) /\
    (forall r, In r P -> dot u p < dot u r -> T * (2 * (dot u r - dot u p)) <= dist2 x r - dist2 x p) /\
    nearest P (along x T u) q /\ nearest P (along x T u) p.
Proof.
  intros P x u p Fp. destruct (meeting x u p P) as [N|[T [q [Hq [A [E M]]]]]].
  - left. split; auto. intros t Ht. apply (before_meeting P x u p); auto. intros q Hq L. apply N in Hq. lra.
  - right. exists T, q. destruct Fp as [[Ip Np] Fp].
    assert (D : dist2 x p < dist2 x q).
    { apply Rnot_le_lt. intro Le. assert (nearest P x q) by (split; auto; intros r Hr; specialize (Np r Hr); lra).
      specialize (Fp q H). lra. }
    assert (HT : 0 < T) by (apply Rnot_le_lt; intro; assert (0 <= - T * (2 * (dot u q - dot u p)))
      by (apply Rmult_le_pos; lra); lra).
    assert (Pat : nearest P (along x T u) p).
    { split; auto. intros r Hr. assert (Er := lead x u T p r). specialize (Np r Hr). specialize (M r Hr).
      destruct (Rlt_dec (dot u p) (dot u r)) as [L|L]; [specialize (M L); lra|].
      assert (0 <= T * (2 * (dot u p - dot u r))) by (apply Rmult_le_pos; lra). lra. }
    assert (Qat : nearest P (along x T u) q).
    { split; auto. intros r Hr. assert (Eq := lead x u T p q). apply Rle_trans with (dist2 (along x T u) p); [lra|].
      apply Pat. auto. }
    split; [|auto 7]. split; [exact HT|]. split.
    + intros t Ht. apply (before_meeting P x u p); [split; [split|]; auto | lra |].
      intros r Hr L. specialize (M r Hr L).
      assert (0 < (T - t) * (2 * (dot u r - dot u p))) by (apply Rmult_lt_0_compat; lra). lra.
    + intros S. apply S in Qat. destruct Qat as [Cq _]. apply Fp in Cq. lra.
Qed.

Theorem contact_set_after_start : forall P x u, P <> [] ->
  exists T, 0 < T /\ forall t, 0 < t < T -> on_segment P x u t.
Proof.
  intros P x u H. destruct (foremost_exists P x u H) as [p Fp].
  destruct (first_meeting P x u p Fp) as [[_ N]|[T [q [[HT [B _]] _]]]].
  - exists 1. split; [lra|]. intros t Ht. apply N. lra.
  - exists T. auto.
Qed.

(* ---- The driver's plane ---- *)

(* K has the contact points on the plane through the driver c that is orthogonal to x - c, and c is in its hull. *)
Theorem foremost_of_driver : forall P x c C, contacts P x C -> nearest_in_hull C x c ->
  let u := vsub x c in let K := filter (on_plane u (dot u c)) C in
  (forall p, In p K <-> foremost P x u p) /\ in_conv K c /\ (forall p, foremost P x u p -> dot u p = dot u c) /\
  (forall p, nearest P x p -> dot u p <= dot u c).
Proof.
  intros P x c C HC N u K. assert (H := proj1 N). assert (A := proj1 (nearest_iff_angles C x c H) N).
  assert (B : forall p, In p C -> dot u p <= dot u c).
  { intros p Hp. specialize (A p Hp). apply Rminus_le.
    replace (dot u p - dot u c) with (dot (vsub x c) (vsub p c)); auto. unfold u. clear. vdestruct; vunfold; ring. }
  assert (X : in_conv K c) by (apply conv_on_plane; auto).
  destruct (hull_nonempty K c X) as [k Hk]. apply on_plane_right in Hk as Hk'. destruct Hk' as [Ck Ek].
  assert (F : forall p, In p K <-> foremost P x u p).
  { intros p. unfold K. rewrite on_plane_right. split.
    - intros [Hp E]. split; [apply HC; auto|]. intros q Hq. rewrite E. apply B, HC, Hq.
    - intros [Hp L]. split; [apply HC; auto|]. apply Rle_antisym; [apply B, HC, Hp|]. rewrite <- Ek. apply L, HC, Ck. }
  split; auto. split; auto. split; [|intros p Hp; apply B, HC, Hp].
  intros p Hp. apply F, on_plane_right in Hp. tauto.
Qed.

(* ---- FC-FLOW-03 ---- *)

(* A point is stationary iff it is its own driver: then the direction x - driver(x) is 0. *)
Theorem stationary_iff_own_driver : forall P x K, contact_set P x K -> (stationary P x K <-> driver P x x).
Proof.
  intros P x K H. destruct (contact_points_exist P x K H) as [C HC]. assert (HN := contact_points P x K C H HC).
  assert (Z : dist2 x x = 0) by (clear; vdestruct; vunfold; ring). split.
  - intros [_ [D [HD X]]]. rewrite <- (points_unique P K C D HC HD) in X. exists C. split; auto. split; auto.
    intros y _. rewrite Z. apply dot_self_nonneg.
  - intros [D [HD [X _]]]. split; auto. exists C. split; auto. apply (conv_incl D); auto.
    intros p Hp. apply HN, HD, Hp.
Qed.

(* ---- FC-FLOW-04 ---- *)

(* All points of the segment have the driver of its start, where t is 0. *)
Theorem driver_along_segment : forall P x c t, driver P x c -> 0 <= t -> (0 < t -> on_segment P x (vsub x c) t) ->
  driver P (along x t (vsub x c)) c.
Proof.
  intros P x c t D Ht S. destruct (Rle_lt_or_eq_dec 0 t Ht) as [T|<-].
  2: { replace (along x 0 (vsub x c)) with x; [exact D|]. apply vec_eq; simpl; ring. }
  specialize (S T). clear Ht. destruct D as [C [HC N]]. destruct (foremost_of_driver P x c C HC N) as [F [X [L _]]].
  set (u := vsub x c) in *. set (K := filter (on_plane u (dot u c)) C) in *.
  exists K. split; [intros p; rewrite F; symmetry; apply S|].
  apply nearest_iff_angles; auto. intros p Hp. apply F, L in Hp. right.
  transitivity ((1 + t) * (dot u p - dot u c)); [|rewrite Hp; ring]. unfold along, u. clear. vdestruct; vunfold; ring.
Qed.

(* ---- FC-FLOW-02 ---- *)

(* The contact set C of the start and K have the dimensions of V-E, E-E, V-F, E-F, F-F or C-C. *)
Theorem segment_types : forall P x c C K s k, driver P x c -> x <> c ->
  contacts P x C -> (forall p, In p K <-> foremost P x (vsub x c) p) ->
  affine_dimension C s -> affine_dimension K k ->
  ((s = 3 /\ k = 2) \/ (s = 2 /\ k = 2) \/ (s = 3 /\ k = 1) \/ (s = 2 /\ k = 1) \/ (s = 1 /\ k = 1) \/
   (s = 0 /\ k = 0))%nat.
Proof.
  intros P x c C K s k [C' [HC' N']] Ne HC HK Ds Dk.
  assert (N : nearest_in_hull C x c).
  { apply (nearest_same C'); auto; intros p Hp; [apply HC, HC', Hp | apply HC', HC, Hp]. }
  destruct (foremost_of_driver P x c C HC N) as [F [X [L B]]].
  set (u := vsub x c) in *. set (K0 := filter (on_plane u (dot u c)) C) in *.
  assert (U : u <> vzero).
  { intros E. apply Ne, dist2_zero. unfold dist2. fold u. rewrite E. apply dot_vzero. }
  assert (Sub : incl K C) by (intros p Hp; apply HC; apply HK in Hp; apply Hp).
  assert (A2 : (k <= 2)%nat) by (apply (affine_dimension_in_plane K k u (dot u c)); auto; intros p Hp; apply L, HK, Hp).
  assert (A3 : (s <= 3)%nat) by (apply (affine_dimension_at_most_3 C); auto).
  assert (Ak : (k <= s)%nat) by (apply (affine_dimension_incl K C); auto).
  assert (A0 : k = 0%nat -> s = 0%nat).
  { intros ->. destruct (hull_nonempty K0 c X) as [p Hp].
    assert (One : forall q, In q K -> q = p).
    { intros q Hq. apply (affine_dimension_0 K); auto. apply HK, F, Hp. }
    assert (Ec : c = p).
    { apply (centre_unique [p]); [| apply conv_in_aff, point_in_conv; left; auto | |].
      - apply conv_in_aff, (conv_incl K0); auto. intros q Hq. left. symmetry. apply One, HK, F, Hq.
      - intros a b [<-|[]] [<-|[]]. reflexivity.
      - intros a b [<-|[]] [<-|[]]. reflexivity. }
    (* the contact points are not farther from x than p, and lie on its side of the plane *)
    assert (Cp : In p C) by (apply Sub, HK, F, Hp).
    assert (Only : forall q, In q C -> q = p).
    { intros q Hq. apply dist2_zero. apply HC in Hq, Cp.
      assert (E : dist2 x q = dist2 x p) by (apply Rle_antisym; [apply Hq, Cp | apply Cp, Hq]).
      specialize (B q Hq). apply Rle_antisym; [|apply dot_self_nonneg]. rewrite Ec in B. revert E B. unfold u.
      rewrite Ec. clear. vdestruct; vunfold. lra. }
    apply (affine_dimension_unique C); auto. apply (affine_dimension_of_one C p); auto. }
  lia.
Qed.

(* All contact points of the segment are contact points of its end, which has a further one. *)
Theorem contact_set_at_end : forall P x u T, segment_end P x u T ->
  (forall p, foremost P x u p -> nearest P (along x T u) p) /\
  exists q, nearest P (along x T u) q /\ ~ foremost P x u q.
Proof.
  intros P x u T [HT [B N]].
  assert (A : forall p, foremost P x u p -> nearest P (along x T u) p).
  { intros p Fp. destruct Fp as [[Ip Np] Fp]. split; auto. intros q Hq. apply Rnot_lt_le. intro L.
    assert (E := lead x u T p q). assert (Nq := Np q Hq). set (d := dist2 x q - dist2 x p) in *.
    set (a := 2 * (dot u q - dot u p)) in *.
    assert (Ha : 0 < a).
    { apply Rnot_le_lt. intro. assert (0 <= T * - a) by (apply Rmult_le_pos; lra). unfold d in *. lra. }
    (* q would have caught up before *)
    assert (Hd : 0 <= d) by (unfold d; lra).
    assert (Hd' : d / a < T).
    { apply Rmult_lt_reg_r with a; auto. replace (d / a * a) with d by (field; lra). lra. }
    assert (H0 : 0 <= d / a) by (apply Rmult_le_pos; [auto | left; apply Rinv_0_lt_compat; auto]).
    assert (S : nearest P (along x ((d / a + T) / 2) u) p) by (apply B; [lra | split; [split|]; auto]).
    destruct S as [_ S]. specialize (S q Hq). assert (E' := lead x u ((d / a + T) / 2) p q). fold d a in E'.
    assert (Z : d / a * a = d) by (field; lra).
    assert (0 < (T - d / a) * a) by (apply Rmult_lt_0_compat; lra). lra. }
  split; auto.
  destruct (contacts_exist P (along x T u)) as [D [d [HD Hd]]].
  { intros ->. apply N. intros p. split; intros H; exfalso; [destruct H as [[] _] | destruct H as [[[] _] _]]. }
  assert (Hp : P <> []) by (intros ->; apply HD in Hd; destruct Hd as [[] _]).
  destruct (foremost_exists P x u Hp) as [p Fp].
  destruct (level_or_off u (dot u p) D) as [All|[q [Hq Nq]]].
  - exfalso. apply N. intros q. split; [|apply A]. intros Nq.
    assert (Eu : dot u q = dot u p) by (apply All, HD, Nq).
    assert (E := lead x u T p q).
    assert (Z : dist2 (along x T u) q = dist2 (along x T u) p).
    { specialize (A p Fp). apply Rle_antisym; [apply Nq, A | apply A, Nq]. }
    destruct Fp as [[Ip Np] Fp]. rewrite Z, Eu in E. assert (Ex : dist2 x q = dist2 x p) by lra.
    split; [split; [apply Nq|]; intros r Hr; rewrite Ex; auto|]. intros r Hr. rewrite Eu. auto.
  - exists q. split; [apply HD; auto|]. intros [Cq Fq]. apply Nq.
    apply Rle_antisym; [apply Fp | apply Fq]; auto. apply Fp.
Qed.

(* The contact set D of the end has a larger dimension than K: with segment_types, only the types of the table exist. *)
Theorem end_types : forall P x u T K D k r, segment_end P x u T ->
  (forall p, In p K <-> foremost P x u p) -> contacts P (along x T u) D ->
  affine_dimension K k -> affine_dimension D r -> (k < r <= 3)%nat.
Proof.
  intros P x u T K D k r HT HK HD Dk Dr. split; [|apply (affine_dimension_at_most_3 D); auto].
  destruct (contact_set_at_end P x u T HT) as [A [q [Nq Fq]]].
  assert (Hp : P <> []) by (intros ->; destruct Nq as [[] _]).
  destruct (foremost_exists P x u Hp) as [p Fp].
  apply (affine_dimension_grows K D k r u (dot u p) q); auto.
  - intros a Ha. apply HD, A, HK, Ha.
  - intros a Ha. apply HK in Ha. destruct Ha as [Ca Fa]. apply Rle_antisym; [apply Fp | apply Fa]; auto. apply Fp.
  - apply HD; auto.
  - intros E. apply Fq. assert (L := lead x u T p q).
    assert (Z : dist2 (along x T u) q = dist2 (along x T u) p).
    { specialize (A p Fp). apply Rle_antisym; [apply Nq, A | apply A, Nq]. }
    destruct Fp as [[Ip Np] Fp]. rewrite Z, E in L. assert (Ex : dist2 x q = dist2 x p) by lra.
    split; [split; [apply Nq|]; intros a Ha; rewrite Ex; auto|]. intros a Ha. rewrite E. auto.
Qed.
