(* What the C++ of src/ computes, as syntax: code/generated/ has the terms that a recording number printed, and this
   page says what they mean. It has four meanings: on IEEE 754 doubles, as C++ computes them; on real numbers that are
   rounded after every operation; on real numbers without rounding; and on integers. *)
From Coq Require Import Reals ZArith List Bool.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import filters.Rounding.
Import ListNotations.
Open Scope R_scope.

Inductive relation := Less | LessEqual | Equal.

Inductive expr :=
  | Var (n : nat)
  | Cst (m e : Z)  (* m 2^e *)
  | Infinite
  | Add (a b : expr) | Sub (a b : expr) | Mul (a b : expr) | Div (a b : expr)
  | Neg (a : expr) | Abs (a : expr) | Root (a : expr)
  | Wide (a : expr)  (* the same number in a wider type *)
  | Choose (r : relation) (a b yes no : expr).

(* A function that answers: comparisons, and what they lead to. *)
Inductive tree (A : Type) := Answer (a : A) | If (r : relation) (a b : expr) (yes no : tree A).
Arguments Answer {A}. Arguments If {A}.

Inductive sign := Negative | Zero | Positive.
Definition is_sign s x := match s with Negative => x < 0 | Zero => x = 0 | Positive => 0 < x end.

(* ---- On doubles ---- *)

Global Instance below_emax : Prec_lt_emax 53 1024 := eq_refl.
Definition double := binary_float 53 1024.
Definition compare_doubles r : double -> double -> bool :=
  match r with Less => Bltb | LessEqual => Bleb | Equal => Beqb end.

Fixpoint on_doubles (x : nat -> double) e : double :=
  match e with
  | Var n => x n
  | Cst m k => binary_normalize 53 1024 _ _ mode_NE m k false
  | Infinite => B754_infinity false
  | Add a b => Bplus mode_NE (on_doubles x a) (on_doubles x b)
  | Sub a b => Bminus mode_NE (on_doubles x a) (on_doubles x b)
  | Mul a b => Bmult mode_NE (on_doubles x a) (on_doubles x b)
  | Div a b => Bdiv mode_NE (on_doubles x a) (on_doubles x b)
  | Neg a => Bopp (on_doubles x a)
  | Abs a => Babs (on_doubles x a)
  | Root a => Bsqrt mode_NE (on_doubles x a)
  | Wide a => on_doubles x a
  | Choose r a b yes no =>
    if compare_doubles r (on_doubles x a) (on_doubles x b) then on_doubles x yes else on_doubles x no
  end.

Fixpoint run {A} (x : nat -> double) (t : tree A) : A :=
  match t with
  | Answer a => a
  | If r a b yes no => if compare_doubles r (on_doubles x a) (on_doubles x b) then run x yes else run x no
  end.

(* ---- On real numbers ---- *)

Definition compare_reals r : R -> R -> bool :=
  match r with Less => Rlt_bool | LessEqual => Rle_bool | Equal => Req_bool end.

(* `round` is what happens to the result of an operation. *)
Fixpoint on_reals (round : R -> R) (x : nat -> R) e : R :=
  match e with
  | Var n => x n
  | Cst m k => F2R (Float radix2 m k)
  | Infinite => 0
  | Add a b => round (on_reals round x a + on_reals round x b)
  | Sub a b => round (on_reals round x a - on_reals round x b)
  | Mul a b => round (on_reals round x a * on_reals round x b)
  | Div a b => round (on_reals round x a / on_reals round x b)
  | Neg a => - on_reals round x a
  | Abs a => Rabs (on_reals round x a)
  | Root a => round (sqrt (on_reals round x a))
  | Wide a => on_reals round x a
  | Choose r a b yes no =>
    if compare_reals r (on_reals round x a) (on_reals round x b) then on_reals round x yes else on_reals round x no
  end.
Definition rounded := on_reals rnd.
Definition exact := on_reals (fun r => r).

(* ---- On integers ---- *)

Definition compare_integers r : Z -> Z -> bool := match r with Less => Z.ltb | LessEqual => Z.leb | Equal => Z.eqb end.
Fixpoint on_integers (x : nat -> Z) e : Z :=
  match e with
  | Var n => x n
  | Cst m k => m * 2 ^ k
  | Infinite => 0
  | Add a b => on_integers x a + on_integers x b
  | Sub a b => on_integers x a - on_integers x b
  | Mul a b => on_integers x a * on_integers x b
  | Div a b => on_integers x a / on_integers x b
  | Neg a => - on_integers x a
  | Abs a => Z.abs (on_integers x a)
  | Root a => Z.sqrt (on_integers x a)
  | Wide a => on_integers x a
  | Choose r a b yes no =>
    if compare_integers r (on_integers x a) (on_integers x b) then on_integers x yes else on_integers x no
  end%Z.

(* ---- Variables in place of expressions ---- *)

Fixpoint replace (x : nat -> expr) e : expr :=
  match e with
  | Var n => x n
  | Cst m k => Cst m k
  | Infinite => Infinite
  | Add a b => Add (replace x a) (replace x b)
  | Sub a b => Sub (replace x a) (replace x b)
  | Mul a b => Mul (replace x a) (replace x b)
  | Div a b => Div (replace x a) (replace x b)
  | Neg a => Neg (replace x a)
  | Abs a => Abs (replace x a)
  | Root a => Root (replace x a)
  | Wide a => Wide (replace x a)
  | Choose r a b yes no => Choose r (replace x a) (replace x b) (replace x yes) (replace x no)
  end.

Lemma on_doubles_replace : forall s x e, on_doubles x (replace s e) = on_doubles (fun n => on_doubles x (s n)) e.
Proof. induction e; simpl; rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4; reflexivity. Qed.
Lemma on_doubles_same : forall x y e, (forall n, x n = y n) -> on_doubles x e = on_doubles y e.
Proof. induction e; simpl; intros; auto; rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by auto; auto. Qed.
Lemma on_reals_same : forall round x y e, (forall n, x n = y n) -> on_reals round x e = on_reals round y e.
Proof. induction e; simpl; intros; auto; rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by auto; auto. Qed.
