(* The stationary points that follow from a Delaunay triangulation, by FC-CERT-03 to 05, and the whole checker.
   The contact set is read off all samples, rather than off cells as FC-CERT-05 does it: those on the sphere. *)
From Coq Require Import ZArith List Bool.
From Flowcert Require Import judge.Judge checker.Simplices checker.Certificate checker.Conditions.
Import ListNotations.
Open Scope Z_scope.

Inductive kind := Index0 | Index1 | Index2 | Index3 | Regular12 | Regular13 | Regular23.
Record stationary_point := StationaryPoint { kind_of : kind; contact_of : simplex; simplex_of : simplex }.

Fixpoint sublists (s : simplex) : list simplex :=
  match s with
  | [] => [[]]
  | a :: s' => map (cons a) (sublists s') ++ sublists s'
  end.
(* The faces of a cell of dimension 1 at least that have the centre of their sphere inside. *)
Definition centred_faces (rows : list zvec) (cell : simplex) : list simplex :=
  filter (fun s => Nat.leb 2 (length s) && centre_is_inside (places rows s)) (sublists (sorted cell)).
Definition simplex_eq_dec (s t : simplex) : {s = t} + {s <> t} := list_eq_dec Nat.eq_dec s t.
Definition centred_simplices (rows : list zvec) (cells : list simplex) : list simplex :=
  nodup simplex_eq_dec (flat_map (centred_faces rows) cells).

Definition cells_at (cells : list simplex) (s : simplex) : list simplex := filter (is_face s) cells.
Definition link_samples (s cell : simplex) : list nat := filter (fun p => negb (has_sample s p)) cell.
Definition is_empty_at (rows : list zvec) (cells : list simplex) (s : simplex) : bool :=
  forallb (fun cell => forallb (fun p => 0 <=? outside (places rows s) (place rows p)) (link_samples s cell))
          (cells_at cells s).
Definition stationary_simplices (rows : list zvec) (cells : list simplex) : list simplex :=
  filter (is_empty_at rows cells) (centred_simplices rows cells).

Definition is_on_sphere (rows : list zvec) (s : simplex) (p : nat) : bool :=
  outside (places rows s) (place rows p) =? 0.
Definition contact_samples (rows : list zvec) (s : simplex) : simplex :=
  filter (is_on_sphere rows s) (names rows).

(* FC-CERT-04. links: the link samples on the sphere, for each cell that has all of its samples there. *)
Definition kind_at (rows : list zvec) (d_plus_1 : nat) (cells : list simplex) (s : simplex) : kind :=
  let links := map (link_samples s) (cells_at cells s) in
  let zeros := nodup Nat.eq_dec (filter (is_on_sphere rows s) (concat links)) in
  let full := filter (forallb (is_on_sphere rows s)) links in
  let by_count :=
    match length s, length zeros with
    | 2%nat, 0%nat => Index1 | 2%nat, 1%nat => Regular12 | 2%nat, _ => Index2
    | 3%nat, 0%nat => Index2 | 3%nat, 1%nat => Regular23 | _, _ => Index3
    end in
  match s, full with
  | [a; b], _ :: _ =>
    if Nat.ltb d_plus_1 4 then by_count
    else if Nat.eqb (length zeros) (length full) then Index3
    else
      let once := filter (fun p => Nat.eqb (count_occ Nat.eq_dec (concat full) p) 1) (concat full) in
      if volume (ZV 0 0 0) (edges (places rows (a :: b :: once))) =? 0 then Regular23 else Regular13
  | _, _ => by_count
  end.

Definition stationary_points (rows : list zvec) (d_plus_1 : nat) (cells : list simplex) : list stationary_point :=
  map (fun p => StationaryPoint Index0 [p] [p]) (names rows) ++
  map (fun s => StationaryPoint (kind_at rows d_plus_1 cells s) (contact_samples rows s) s)
      (stationary_simplices rows cells).

(* What a list of cells proves. *)
Definition check_cells_of (rows : list zvec) (d_plus_1 : nat) (cells : list simplex) : result (list stationary_point) :=
  if forallb (fun c => Nat.eqb (length c) d_plus_1 && forallb (has_sample (names rows)) c) cells then
    do _ <- check_conditions rows d_plus_1 cells; Holds (stationary_points rows d_plus_1 cells)
  else Undecodable.

(* What a certificate's body proves, behind a header with the dimension d and so many cells. *)
Definition check_certificate (rows : list zvec) (d_plus_1 count : nat) (body : list Z)
  : result (list simplex * list stationary_point) :=
  do cells <- decode (names rows) d_plus_1 count body;
  do points <- check_cells_of rows d_plus_1 cells; Holds (cells, points).
