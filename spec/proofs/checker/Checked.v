(* What it means that the checker accepts: which of its tests have succeeded. *)
From Coq Require Import ZArith Lia List Bool.
From Flowcert Require Import judge.Judge.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.StationaryList checker.Sound.
Import ListNotations.

Lemma require_holds : forall A b c (r : result A) a, require b c r = Holds a -> b = true /\ r = Holds a.
Proof. intros A [] c r a H; simpl in H; [auto | discriminate]. Qed.
Lemma and_then_holds : forall A B (r : result A) (f : A -> result B) x, and_then r f = Holds x ->
  exists a, r = Holds a /\ f a = Holds x.
Proof. intros A B [|c|a] f x H; simpl in H; try discriminate. eauto. Qed.

Lemma check_cells_holds : forall rows n all l, check_cells rows n all l = Holds tt -> forall k c, In (k, c) l ->
  cell_is_positive rows n c = true /\ forall f, In f (facets_of k c) -> facet_is_delaunay rows all f = true.
Proof.
  intros rows n all. induction l as [|[k c] l IH]; intros H k' c' Hin; [destruct Hin|]. simpl in H.
  apply require_holds in H. destruct H as [V H]. apply require_holds in H. destruct H as [T H].
  destruct Hin as [E|Hin]; [|apply IH; auto]. injection E; intros; subst. split; auto. apply forallb_forall. auto.
Qed.

(* T4 to T7: of the facets without a mate. *)
Record hull_checked (rows : list zvec) (first : simplex) (cells : list simplex) : Prop := {
  hull_sees_middle : forall f, In f (hull_facets (facets cells)) ->
    sees_middle rows (normal (places rows first)) first f = true;
  hull_ridges : check_ridges rows (normal (places rows first)) (hull_facets (facets cells)) = Holds tt;
  hull_ray : ray_is_free rows (normal (places rows first)) first (hull_facets (facets cells)) = true }.

Theorem conditions_hold : forall rows m first cells, In first cells -> hd_error cells = Some first ->
  (forall c, In c cells -> length c = m /\ forall p, In p c -> In p (names rows)) ->
  check_conditions rows m cells = Holds tt -> accepted rows first cells /\ hull_checked rows first cells.
Proof.
  intros rows m first cells Hf Hd Names H. destruct cells as [|c0 rest]; [destruct Hf|].
  simpl in Hd. injection Hd. intros ->. unfold check_conditions in H. cbv zeta in H.
  set (cells := first :: rest) in *.
  apply require_holds in H. destruct H as [_ H]. apply require_holds in H. destruct H as [T0 H].
  apply and_then_holds in H. destruct H as [[] [T13 H]].
  apply require_holds in H. destruct H as [T2 H]. apply require_holds in H. destruct H as [T5 H].
  apply and_then_holds in H. destruct H as [[] [T46 H]]. apply require_holds in H. destruct H as [T7 H].
  apply require_holds in H. destruct H as [T8 _].
  assert (Cell : forall k c, nth_error cells k = Some c -> cell_is_positive rows (normal (places rows first)) c = true
    /\
    forall i, (i < length c)%nat -> facet_is_delaunay rows (facets cells) (facet_at k c i) = true).
  { intros k c Hk. destruct (check_cells_holds _ _ _ _ T13 k c) as [V T].
    - apply in_numbered. rewrite Nat.sub_0_r. split; [lia | auto].
    - split; auto. intros i Bi. apply T. unfold facets_of. apply in_map. apply in_seq. lia. }
  split; split.
  - intros c p Hc Hp. apply (Names c Hc). auto.
  - intros c Hc. destruct (Names c Hc) as [-> _]. symmetry. apply (Names first). left. auto.
  - left. auto.
  - intros c Hc. apply In_nth_error in Hc. destruct Hc as [k Hk]. apply Z.ltb_lt. apply (Cell k c Hk).
  - intros p Hp. rewrite forallb_forall in T0. auto.
  - intros f g Hf' Hg. apply in_facets in Hf'. destruct Hf' as [k [c [i [Hk [Bi ->]]]]].
    destruct (Cell k c Hk) as [_ T]. specialize (T i Bi). unfold facet_is_delaunay in T.
    rewrite forallb_forall in T. apply Z.leb_le. apply T. auto.
  - intros f Hf'. rewrite forallb_forall in T2. auto.
  - intros p Hp. rewrite forallb_forall in T8. apply T8 in Hp. apply existsb_exists in Hp.
    destruct Hp as [c [Hc Ic]]. exists c. split; auto. apply has_sample_spec. auto.
  - intros f Hf'. rewrite forallb_forall in T5. auto.
  - auto.
  - auto.
Qed.

Theorem checked_holds : forall rows m cells points, check_cells_of rows m cells = Holds points ->
  points = stationary_points rows m cells /\
  ((cells = [] /\ length (names rows) = m /\ (m < 2)%nat) \/
   exists first, In first cells /\ accepted rows first cells /\ hull_checked rows first cells).
Proof.
  intros rows m cells points H. unfold check_cells_of in H.
  match type of H with (if ?test then _ else _) = _ => destruct test eqn:F; [|discriminate] end.
  apply and_then_holds in H. destruct H as [[] [C H]]. injection H. intros <-. split; auto.
  destruct cells as [|first rest].
  - left. simpl in C. apply require_holds in C. destruct C as [C _]. apply andb_true_iff in C. destruct C as [C1 C2].
    apply Nat.ltb_lt in C1. apply Nat.eqb_eq in C2. auto.
  - right. exists first. split; [left; auto|]. apply (conditions_hold rows m); auto; [left; auto|].
    intros c Hc. rewrite forallb_forall in F. apply F in Hc. apply andb_true_iff in Hc. destruct Hc as [L N].
    apply Nat.eqb_eq in L. split; auto. intros p Hp. rewrite forallb_forall in N. apply has_sample_spec. auto.
Qed.
