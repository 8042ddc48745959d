(* The conditions T0 to T8 of FC-CERT-02, asked of a list of cells.
   Facets of two cells with the same samples are a pair, so that no pairing is given. *)
From Coq Require Import ZArith List Bool.
From Flowcert Require Import judge.Judge checker.Simplices checker.Certificate.
Import ListNotations.
Open Scope Z_scope.

Definition require {A} (b : bool) (c : condition) (r : result A) : result A := if b then r else Rejected c.

(* The first row of each class of equal points. *)
Definition same_place (p q : zvec) : bool := (zx p =? zx q) && (zy p =? zy q) && (zz p =? zz q).
Fixpoint names_from (i : nat) (before : list zvec) (rows : list zvec) : list nat :=
  match rows with
  | [] => []
  | p :: rows' =>
    if existsb (same_place p) before then names_from (S i) before rows'
    else i :: names_from (S i) (p :: before) rows'
  end.
Definition names (rows : list zvec) : list nat := names_from 0 [] rows.

(* ---- Facets ---- *)

(* A facet: its cell, the number of the cell, its place; its samples in ascending order, and its orientation. *)
Record facet := Facet { cell_of : simplex; cell_number : nat; place_of : nat; samples_of : simplex; turn_of : bool }.
Definition opposite (f : facet) : nat := nth (place_of f) (cell_of f) 0%nat.
Definition vertices (f : facet) : simplex := without (place_of f) (cell_of f).
Definition facet_at (c : nat) (cell : simplex) (i : nat) : facet :=
  let '(key, turn) := face_of cell false i in Facet cell c i key turn.
Definition facets_of (c : nat) (cell : simplex) : list facet := map (facet_at c cell) (seq 0 (length cell)).
Definition numbered (cells : list simplex) : list (nat * simplex) := combine (seq 0 (length cells)) cells.
Definition facets (cells : list simplex) : list facet := flat_map (fun '(c, cell) => facets_of c cell) (numbered cells).

Definition is_same_facet (f g : facet) : bool :=
  Nat.eqb (cell_number f) (cell_number g) && Nat.eqb (place_of f) (place_of g).
Definition mates (all : list facet) (f : facet) : list facet :=
  filter (fun g => same_samples (samples_of g) (samples_of f) && negb (is_same_facet f g)) all.

(* The sign that the volume of the vectors from x to the facet's vertices has for x on the cell's side. *)
Definition sided (f : facet) (v : Z) : Z := if Nat.odd (place_of f) then - v else v.
Definition inner_side (rows : list zvec) (n : zvec) (f : facet) (x : zvec) : Z :=
  sided f (volume n (seen_from x (places rows (vertices f)))).

(* ---- T0 ---- *)

(* In dimension 1 and 2: the edge of the first cell, or its normal. *)
Definition normal (first : list zvec) : zvec :=
  match edges first with [a] => a | [a; b] => zcross a b | _ => ZV 0 0 0 end.
Definition is_in_hull_of (first : list zvec) (p : zvec) : bool :=
  let v := zsub p (origin first) in
  match edges first with
  | [a] => negb (znonzero (zcross a v))
  | [a; b] => zdot (zcross a b) v =? 0
  | _ => true
  end.
Definition is_flat (first : list zvec) : bool :=
  match edges first with
  | [a] => negb (znonzero a)
  | [a; b] => negb (znonzero (zcross a b))
  | _ => false
  end.

(* ---- T1 and T3, cell by cell; then T2 ---- *)

Definition cell_is_positive (rows : list zvec) (n : zvec) (cell : simplex) : bool :=
  0 <? volume n (edges (places rows cell)).
Definition facet_is_delaunay (rows : list zvec) (all : list facet) (f : facet) : bool :=
  forallb (fun g => 0 <=? outside (places rows (cell_of f)) (place rows (opposite g))) (mates all f).
Fixpoint check_cells (rows : list zvec) (n : zvec) (all : list facet) (cells : list (nat * simplex)) : result unit :=
  match cells with
  | [] => Holds tt
  | (c, cell) :: cells' =>
    require (cell_is_positive rows n cell) T1
      (require (forallb (facet_is_delaunay rows all) (facets_of c cell)) T3 (check_cells rows n all cells'))
  end.
Definition is_paired_well (all : list facet) (f : facet) : bool :=
  match mates all f with
  | [] => true
  | [g] => xorb (turn_of f) (turn_of g)
  | _ => false
  end.

(* ---- T4 to T7, of the facets without a mate ---- *)

Definition hull_facets (all : list facet) : list facet :=
  filter (fun f => match mates all f with [] => true | _ => false end) all.

Definition middle (rows : list zvec) (first : simplex) : zvec := fold_right zadd (ZV 0 0 0) (places rows first).
(* From o to a sample, times d + 1. *)
Definition from_middle (rows : list zvec) (first : simplex) (p : nat) : zvec :=
  zsub (zscale (Z.of_nat (length first)) (place rows p)) (middle rows first).
Definition sees_middle (rows : list zvec) (n : zvec) (first : simplex) (f : facet) : bool :=
  0 <? sided f (volume n (map (from_middle rows first) (vertices f))).

Record ridge := Ridge { ridge_facet : facet; ridge_turn : bool; ridge_opposite : nat }.
Fixpoint precedes (s t : simplex) : bool :=
  match s, t with
  | a :: s', b :: t' => Nat.ltb a b || (Nat.eqb a b && precedes s' t')
  | _, _ => false
  end.
Definition ridges_of (f : facet) : list (simplex * ridge) :=
  map (fun i => let '(key, turn) := face_of (vertices f) (Nat.odd (place_of f)) i in
                (key, Ridge f turn (nth i (vertices f) 0%nat))) (seq 0 (length (vertices f))).
Definition ridges (hull : list facet) : list (simplex * ridge) := flat_map ridges_of hull.
(* In ascending order, each once. *)
Fixpoint insert_key (key : simplex) (keys : list simplex) : list simplex :=
  match keys with
  | [] => [key]
  | k :: keys' =>
    if same_samples k key then keys
    else if precedes key k then key :: keys
    else k :: insert_key key keys'
  end.
Definition ridge_keys (all : list (simplex * ridge)) : list simplex :=
  fold_right (fun '(key, _) keys => insert_key key keys) [] all.
Definition at_ridge (all : list (simplex * ridge)) (key : simplex) : list ridge :=
  map snd (filter (fun '(k, _) => same_samples k key) all).

Definition check_ridge (rows : list zvec) (n : zvec) (at_it : list ridge) (rest : result unit) : result unit :=
  match at_it with
  | [a; b] =>
    require (xorb (ridge_turn a) (ridge_turn b)) T4
      (require (0 <=? inner_side rows n (ridge_facet a) (place rows (ridge_opposite b))) T6 rest)
  | _ => Rejected T4
  end.
Definition check_ridges (rows : list zvec) (n : zvec) (hull : list facet) : result unit :=
  let all := ridges hull in
  match all with
  | [] => Rejected T4
  | _ => fold_right (fun key rest => check_ridge rows n (at_ridge all key) rest) (Holds tt) (ridge_keys all)
  end.

Definition meets_ray (n : zvec) (ray : zvec) (v : list zvec) (f : facet) : bool :=
  forallb (fun i => 0 <=? sided f (volume n (firstn i v ++ ray :: skipn (S i) v))) (seq 0 (length v)).
Definition ray_is_free (rows : list zvec) (n : zvec) (first : simplex) (hull : list facet) : bool :=
  match hull with
  | [] => true
  | f :: others =>
    let seen := fun g => map (from_middle rows first) (vertices g) in
    let ray := fold_right zadd (ZV 0 0 0) (seen f) in
    forallb (fun g => negb (meets_ray n ray (seen g) g)) others
  end.

(* ---- All of them ---- *)

Definition check_conditions (rows : list zvec) (d_plus_1 : nat) (cells : list simplex) : result unit :=
  match cells with
  | [] => require (Nat.ltb d_plus_1 2 && Nat.eqb (length (names rows)) d_plus_1) T0 (Holds tt)
  | first :: _ =>
    let corners := places rows first in
    let n := normal corners in
    let all := facets cells in
    let hull := hull_facets all in
    require (negb (is_flat corners)) T1
    (require (forallb (is_in_hull_of corners) rows) T0
    (do _ <- check_cells rows n all (numbered cells);
    require (forallb (is_paired_well all) all) T2
    (require (forallb (sees_middle rows n first) hull) T5
    (do _ <- check_ridges rows n hull;
    require (ray_is_free rows n first hull) T7
    (require (forallb (fun p => existsb (fun c => has_sample c p) cells) (names rows)) T8
    (Holds tt))))))
  end.
