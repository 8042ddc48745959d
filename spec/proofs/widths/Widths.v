(* The integers of a fixed size (src/geometry/integer_grid.h) hold every value that the predicates and the signs of a
   cell form in them: each subexpression, not only the result. The expressions are the generated ones, of the templates
   that the code calls with these integers. *)
From Coq Require Import ZArith Lia List Bool.
From Flowcert Require Import code.Expression code.generated.Constants code.generated.Predicates code.generated.Cells.
Import ListNotations.
Open Scope Z_scope.

(* A bound of the size, for variables up to D; -1 for what integers do not have. *)
Fixpoint size_limit D e : Z :=
  match e with
  | Var _ => D
  | Cst m k => if k <? 0 then -1 else Z.abs m * 2 ^ k
  | Add a b | Sub a b => size_limit D a + size_limit D b
  | Mul a b => size_limit D a * size_limit D b
  | Neg a | Abs a | Wide a => size_limit D a
  | _ => -1
  end.
(* Every value that is formed: in the wide type, or in the narrow one. What is widened was formed in the narrow one. *)
Inductive formed : bool -> expr -> bool -> expr -> Prop :=
  | FHere : forall w e, formed w e w e
  | FAdd1 : forall w a b v x, formed w a v x -> formed w (Add a b) v x
  | FAdd2 : forall w a b v x, formed w b v x -> formed w (Add a b) v x
  | FSub1 : forall w a b v x, formed w a v x -> formed w (Sub a b) v x
  | FSub2 : forall w a b v x, formed w b v x -> formed w (Sub a b) v x
  | FMul1 : forall w a b v x, formed w a v x -> formed w (Mul a b) v x
  | FMul2 : forall w a b v x, formed w b v x -> formed w (Mul a b) v x
  | FNeg : forall w a v x, formed w a v x -> formed w (Neg a) v x
  | FAbs : forall w a v x, formed w a v x -> formed w (Abs a) v x
  | FWide : forall w a v x, formed false a v x -> formed w (Wide a) v x.

(* narrow, wide: the greatest integers of the two types. *)
Fixpoint fits D (narrow wide : Z) (is_wide : bool) e : bool :=
  (size_limit D e <=? if is_wide then wide else narrow) && (0 <=? size_limit D e) &&
  match e with
  | Var _ => true
  | Cst _ k => 0 <=? k
  | Add a b | Sub a b | Mul a b => fits D narrow wide is_wide a && fits D narrow wide is_wide b
  | Neg a | Abs a => fits D narrow wide is_wide a
  | Wide a => fits D narrow wide false a
  | _ => false
  end.

Lemma size_limit_sound : forall r D narrow wide e, 0 <= D -> (forall n, Z.abs (r n) <= D) ->
  forall w, fits D narrow wide w e = true -> Z.abs (on_integers r e) <= size_limit D e.
Proof.
  intros r D narrow wide e HD Hr. induction e; intros w H; cbn [fits on_integers size_limit] in *;
    rewrite ?andb_true_iff in H; destruct H as [[H1 H2] H3]; try discriminate; auto.
  - apply Z.leb_le in H3. destruct (Z.ltb_spec e 0); [lia|]. rewrite Z.abs_mul.
    rewrite (Z.abs_eq (2 ^ e)); [reflexivity|]. apply Z.pow_nonneg. discriminate.
  - destruct H3 as [A B]. apply IHe1 in A. apply IHe2 in B. lia.
  - destruct H3 as [A B]. apply IHe1 in A. apply IHe2 in B. lia.
  - destruct H3 as [A B]. apply IHe1 in A. apply IHe2 in B. rewrite Z.abs_mul.
    apply Z.mul_le_mono_nonneg; auto using Z.abs_nonneg.
  - apply IHe in H3. lia.
  - apply IHe in H3. lia.
  - apply IHe in H3. exact H3.
Qed.

Theorem fits_sound : forall r D narrow wide, 0 <= D -> (forall n, Z.abs (r n) <= D) ->
  forall w e v x, formed w e v x -> fits D narrow wide w e = true ->
  Z.abs (on_integers r x) <= if v then wide else narrow.
Proof.
  intros r D narrow wide HD Hr w e v x F.
  induction F; intro H; try (apply IHF; cbn [fits] in H; rewrite ?andb_true_iff in H; tauto).
  generalize (size_limit_sound r D narrow wide e HD Hr w H). intro S.
  assert (L : size_limit D e <= if w then wide else narrow).
  { destruct e; cbn [fits] in H; rewrite ?andb_true_iff, ?Z.leb_le in H; tauto. }
  lia.
Qed.

(* All that a function forms: what it compares, and what it answers. *)
Fixpoint tree_fits D narrow wide is_wide (t : tree expr) : bool :=
  match t with
  | Answer e => fits D narrow wide is_wide e
  | If _ a b yes no => fits D narrow wide is_wide a && fits D narrow wide is_wide b &&
                       tree_fits D narrow wide is_wide yes && tree_fits D narrow wide is_wide no
  end.
Inductive in_tree : tree expr -> expr -> Prop :=
  | IAnswer : forall e, in_tree (Answer e) e
  | ILeft : forall r a b yes no, in_tree (If r a b yes no) a
  | IRight : forall r a b yes no, in_tree (If r a b yes no) b
  | IYes : forall r a b yes no e, in_tree yes e -> in_tree (If r a b yes no) e
  | INo : forall r a b yes no e, in_tree no e -> in_tree (If r a b yes no) e.
Theorem tree_fits_sound : forall D narrow wide w t e, in_tree t e -> tree_fits D narrow wide w t = true ->
  fits D narrow wide w e = true.
Proof. induction 1; cbn [tree_fits]; rewrite ?andb_true_iff; tauto. Qed.

(* ---- The rungs ---- *)

(* Coordinates are below 2^bits, so their differences are below 2^(bits + 1). *)
Definition reach (bits : Z * Z) := 2 ^ (fst bits * 2 ^ snd bits + 1).
Definition int64 := 2 ^ 63 - 1.
Definition int128 := 2 ^ 127 - 1.
Definition wide512 := 2 ^ 512 - 1.

(* Degree 2 is not promoted. *)
Definition predicates_fit D narrow wide :=
  tree_fits D narrow wide false Angle.integers &&
  forallb (tree_fits D narrow wide true)
    [SideOfPlane.integers; OutsideSphere.integers; Orientation.integers; OutsideCircle.integers].
Theorem small_predicates_fit : predicates_fit (reach kSmallBits) int64 int128 = true.
Proof. vm_compute. reflexivity. Qed.
Theorem narrow_predicates_fit : predicates_fit (reach kNarrowBits) int128 wide512 = true.
Proof. vm_compute. reflexivity. Qed.
Theorem wide_predicates_fit : predicates_fit (reach kWideBits) wide512 wide512 = true.
Proof. vm_compute. reflexivity. Qed.

Definition cell_angles := [CellIntegers.angle_0; CellIntegers.angle_1; CellIntegers.angle_2; CellIntegers.angle_3;
  CellIntegers.angle_4; CellIntegers.angle_5; CellIntegers.angle_6; CellIntegers.angle_7; CellIntegers.angle_8;
  CellIntegers.angle_9; CellIntegers.angle_10; CellIntegers.angle_11].
Definition cell_sides := [CellIntegers.side_0; CellIntegers.side_1; CellIntegers.side_2; CellIntegers.side_3].
Theorem cell_fits : forallb (fits (reach kSmallBits) int64 int128 false) cell_angles &&
  forallb (fits (reach kSmallBits) int64 int128 true) cell_sides = true.
Proof. vm_compute. reflexivity. Qed.

(* One bit more, or a few, and something does not fit: the limits mean something. *)
Theorem wide_84_bits_do_not_fit : predicates_fit (2 ^ 85) wide512 wide512 = false.
Proof. vm_compute. reflexivity. Qed.
Theorem narrow_62_bits_do_not_fit : predicates_fit (2 ^ 63) int128 wide512 = false.
Proof. vm_compute. reflexivity. Qed.
Theorem small_20_bits_do_not_fit : predicates_fit (2 ^ 21) int64 int128 = false.
Proof. vm_compute. reflexivity. Qed.
