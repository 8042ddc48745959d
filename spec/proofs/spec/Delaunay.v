(* What a Delaunay triangulation of points in space, in a plane or on a line is. *)
From Coq Require Import Reals List.
From Flowcert Require Import algebra.Vector3 spec.Hull.
Import ListNotations.
Open Scope R_scope.

(* P is the samples, each once. A cell is a list of its samples. *)
Record delaunay_triangulation (P : list vec) (cells : list (list vec)) : Prop := {
  vertices_are_samples : forall p, In p P <-> exists c, In c cells /\ In p c;
  cells_are_simplices : forall c w w', In c cells -> length w = length c -> length w' = length c ->
    sum w = 1 -> sum w' = 1 -> comb w c = comb w' c -> w = w';
  cells_are_maximal : forall c c', In c cells -> In c' cells -> incl c c' -> c = c';
  each_cell_once : NoDup cells;
  cells_fill_the_hull : forall x, in_conv P x <-> exists c, In c cells /\ in_conv c x;
  cells_meet_in_faces : forall c c' x, In c cells -> In c' cells -> in_conv c x -> in_conv c' x ->
    exists s, incl s c /\ incl s c' /\ in_conv s x;
  spheres_exist : forall c, In c cells -> exists z r2, forall v, In v c -> dist2 z v = r2;
  spheres_are_empty : forall c z r2 p, In c cells -> (forall v, In v c -> dist2 z v = r2) -> In p P ->
    r2 <= dist2 z p }.
