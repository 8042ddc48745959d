(* The decoder of a certificate's body (FC-FILE-49): from bytes to cells, with T2.
   Nothing rests on it: the conditions are asked of the cells that it returns, T2 once more among them. *)
From Coq Require Import ZArith List Bool.
From Flowcert Require Import judge.Judge checker.Simplices.
Import ListNotations.
Open Scope Z_scope.

Inductive condition := T0 | T1 | T2 | T3 | T4 | T5 | T6 | T7 | T8.
Inductive result (A : Type) := Undecodable | Rejected (c : condition) | Holds (a : A).
Arguments Undecodable {A}. Arguments Rejected {A} c. Arguments Holds {A} a.

Definition and_then {A B} (r : result A) (f : A -> result B) : result B :=
  match r with Undecodable => Undecodable | Rejected c => Rejected c | Holds a => f a end.
Notation "'do' x <- r ; f" := (and_then r (fun x => f)) (at level 200, x pattern, r at level 100).

(* 7 bits a byte, the low ones first; at most so many bytes. *)
Fixpoint number (at_most : nat) (bytes : list Z) : result (Z * list Z) :=
  match at_most, bytes with
  | S n, b :: rest =>
    if b <? 128 then Holds (b, rest)
    else do (v, rest') <- number n rest; Holds (b - 128 + 128 * v, rest')
  | _, _ => Undecodable
  end.

(* A sample is known by the first row of its class. *)
Definition sample (names : list nat) (i : Z) : result nat :=
  if (0 <=? i) && (i <? 8589934593) && has_sample names (Z.to_nat i) then Holds (Z.to_nat i) else Undecodable.

Fixpoint first_cell (names : list nat) (n : nat) (bytes : list Z) : result (simplex * list Z) :=
  match n with
  | O => Holds ([], bytes)
  | S m =>
    do (i, rest) <- number 5 bytes;
    do p <- sample names i;
    do (cell, rest') <- first_cell names m rest;
    Holds (p :: cell, rest')
  end.

(* What is known of facets: their samples, and the orientation of one that is open, or nothing where no further cell may
   come. An open facet on the stack: its cell, its place, its samples. *)
Definition table := list (simplex * option bool).
Definition open_facet := (simplex * nat * simplex)%type.

Fixpoint find_facet (key : simplex) (known : table) : option (option bool) :=
  match known with
  | [] => None
  | (k, s) :: known' => if same_samples k key then Some s else find_facet key known'
  end.
Definition close (key : simplex) (known : table) : table := (key, None) :: known.

Fixpoint enter (cell : simplex) (i n : nat) (known : table) (opened : list open_facet)
  : result (table * list open_facet) :=
  match n with
  | O => Holds (known, opened)
  | S m =>
    let '(key, turn) := face_of cell false i in
    match find_facet key known with
    | None => enter cell (S i) m ((key, Some turn) :: known) ((cell, i, key) :: opened)
    | Some None => Rejected T2
    | Some (Some other) =>
      if Bool.eqb turn other then Rejected T2 else enter cell (S i) m (close key known) opened
    end
  end.

Definition swapped (cell : simplex) (j k : nat) : simplex :=
  let a := nth j cell 0%nat in
  let b := nth k cell 0%nat in
  map (fun '(i, p) => if Nat.eqb i j then b else if Nat.eqb i k then a else p) (combine (seq 0 (length cell)) cell).
Definition replaced (cell : simplex) (i p : nat) : simplex := firstn i cell ++ p :: skipn (S i) cell.
Definition step (code : Z) : Z := if Z.odd code then code / 2 else - (code / 2).
Definition cell_behind (cell : simplex) (i p : nat) : simplex :=
  let next := replaced cell i p in
  match cell, i with
  | [_; _], _ => swapped next 0 1
  | _, O => swapped next 1 2
  | _, S O => swapped next 0 2
  | _, _ => swapped next 0 1
  end.

Fixpoint glue (fuel : nat) (names : list nat) (remaining : nat) (cells : list simplex) (known : table)
  (stack : list open_facet) (bytes : list Z) : result (list simplex) :=
  match fuel, stack with
  | _, [] => match remaining, bytes with O, [] => Holds (rev cells) | _, _ => Undecodable end
  | O, _ => Undecodable
  | S fuel', (cell, i, key) :: stack' =>
    match find_facet key known with
    | Some None => glue fuel' names remaining cells known stack' bytes
    | _ =>
      do (code, rest) <- number 5 bytes;
      if code =? 0 then glue fuel' names remaining cells (close key known) stack' rest
      else match remaining with
      | O => Undecodable
      | S fewer =>
        do p <- sample names (Z.of_nat (nth i cell 0%nat) + step code);
        let next := cell_behind cell i p in
        do (known', stack'') <- enter next 0 (length next) known stack';
        glue fuel' names fewer (next :: cells) known' stack'' rest
      end
    end
  end.

(* n is d + 1; count is the number of cells that the header says. *)
Definition decode (names : list nat) (n count : nat) (bytes : list Z) : result (list simplex) :=
  match count with
  | O => match bytes with [] => Holds [] | _ => Undecodable end
  | S fewer =>
    do (cell, rest) <- first_cell names n bytes;
    do (known, stack) <- enter cell 0 n [] [];
    glue (n * count) names fewer [cell] known stack rest
  end.
