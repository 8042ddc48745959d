(* The crossing of a facet as src/flow/kernels/direction_across.h computes it: the parts of the generated terms by name.
   direction_behind() is one term, and those of step_across() are that term with the parts of a passage in place of its
   variables: through a triangle, over a corner of a polygon that keeps one end of the edge, and to an edge of a polygon
   that has neither end. *)
From Coq Require Import Reals ZArith List.
From Flowcert Require Import code.Expression code.generated.Constants filters.Terms filters.Filter filters.Directions
  filters.DirectionSigns filters.DirectionOfVector.
From Flowcert Require filters.DirectionStarts.
Import ListNotations.

(* ---- direction_behind() ---- *)

(* Vector 0 is the direction, 2 is g, 4 is the drop, 6 is the edge and 7 the next one. *)
Definition roundoff := Cst (fst kUnitRoundoff) (snd kUnitRoundoff).
Definition times_roundoff (k : Z * Z) := Mul (Cst (fst k) (snd k)) roundoff.
Definition old_error := Var 3.
Definition angle_form := Var 9.
Definition seen_square_size := Var 10.
Definition next_angle_form := Var 15.
Definition way_square_size := Var 16.
Definition squared_ratio := Var 17.
Definition approach_behind := edot (given 0) (given 2).
Definition part_behind i := Add (Mul approach_behind (Var (12 + i))) (Mul (Mul (Cst 1 1) angle_form) (Var i)).
Definition vector_behind := Triple (part_behind 0) (part_behind 1) (part_behind 2).
Definition inverse_behind := Div one (Root (edot vector_behind vector_behind)).
Definition angle_form_bound := Mul (times_roundoff kAngleFormBound) seen_square_size.
Definition approach_bound_behind := Mul (Add old_error (times_roundoff kExitBound)) (Root seen_square_size).
Definition factor_behind := Choose Less approach_bound_behind approach_behind inverse_behind
  (Choose Less angle_form_bound angle_form inverse_behind (Neg inverse_behind)).
Definition angle_behind := Add (Abs angle_form) angle_form_bound.
Definition scaling_behind := Root (Div (Mul squared_ratio (square 7)) (square 6)).
Definition height_behind :=
  Mul (Add (Abs next_angle_form) (Mul (times_roundoff kHeightBound) way_square_size)) scaling_behind.
Definition turn_behind := Mul (Mul (Mul (Mul (Cst 1 2) angle_behind) height_behind) inverse_behind) inverse_behind.
Definition norm_behind := Mul (Mul (Cst 1 1) (DirectionStarts.most angle_behind height_behind)) inverse_behind.
Definition rounding_behind := Mul (Mul (times_roundoff kCrossingBound) way_square_size) inverse_behind.
Definition slack_behind := Add (Mul (Add turn_behind norm_behind) old_error) rounding_behind.
Definition error_behind := Mul (Add (Mul turn_behind old_error) rounding_behind)
  (Add one (Mul (Cst (fst kTangentBehind) (snd kTangentBehind)) slack_behind)).
Definition along_next := Div (edot vector_behind (given 7)) (square 7).
Definition coordinate_behind i := Mul factor_behind (Sub (part_behind i) (Mul along_next (Var (21 + i)))).

Definition if_in_range e (rest : tree (option sign)) :=
  If LessEqual low_square e (If LessEqual e high_square rest (Answer None)) (Answer None).
Definition if_error_is_small :=
  If Less (Cst 0 0) inverse_behind (If Less slack_behind largest_error (Answer (Some Positive)) (Answer None))
    (Answer None).
Lemma behind_match : Code.Behind.u_x = coordinate_behind 0 /\ Code.Behind.u_y = coordinate_behind 1 /\
  Code.Behind.u_z = coordinate_behind 2 /\ Code.Behind.error = error_behind /\
  Code.Behind.is_known = If Less old_error one
    (if_in_range seen_square_size (if_in_range (square 6) (if_in_range (square 7)
      (If Less approach_bound_behind approach_behind if_error_is_small
      (If Less angle_form_bound angle_form if_error_is_small
      (If Less approach_behind (Neg approach_bound_behind) if_error_is_small
      (If Less angle_form (Neg angle_form_bound) if_error_is_small (Answer None)))))))) (Answer None).
Proof. vm_compute. repeat split. Qed.

(* ---- step_across() ---- *)

Definition from_inputs pairs {k} (t : term k) : shape k :=
  match k return shape k -> shape k with
  | Scalar => fun e => replace (inputs pairs) e
  | Vector => fun v => Triple (replace (inputs pairs) (tx v)) (replace (inputs pairs) (ty v))
                              (replace (inputs pairs) (tz v))
  end (flatten t).
Definition sum_seen := VPlus (Given 1) (Given 2).
Definition angle_seen := Dot (Given 1) (Given 2).
(* Vector 1 leads from p0 to q, and vector 2 from p1 to q. `ratio` and `size` are expressions in the vectors. *)
Definition passage pairs (drop e next : term Vector) (angle : term Scalar) size ratio n : expr :=
  let vector t := from_inputs pairs t in
  match n with
  | 0%nat | 1%nat | 2%nat => Var (18 + n)
  | 3%nat => Var 21
  | 6%nat | 7%nat | 8%nat => part (n - 6) (vector sum_seen)
  | 9%nat => from_inputs pairs angle_seen
  | 10%nat => size_square pairs 1 2
  | 12%nat | 13%nat | 14%nat => part (n - 12) (vector drop)
  | 15%nat => from_inputs pairs angle
  | 16%nat => replace (inputs pairs) size
  | 17%nat => replace (inputs pairs) ratio
  | 18%nat | 19%nat | 20%nat => part (n - 18) (vector e)
  | 21%nat | 22%nat | 23%nat => part (n - 21) (vector next)
  | _ => Cst 0 0
  end.

Definition is_passage (through : nat -> expr) u_x u_y u_z error known :=
  u_x = replace through Code.Behind.u_x /\ u_y = replace through Code.Behind.u_y /\
  u_z = replace through Code.Behind.u_z /\ error = replace through Code.Behind.error /\
  known = replace_in_tree through Code.Behind.is_known.

(* The triangle p0 p1 q: the next edge is p0 q. Vector 3 leads from q to p1. *)
Definition triangle_pairs := [(0, 2); (1, 2); (2, 1); (0, 1)]%nat.
Definition in_triangle := passage triangle_pairs (Given 3) (Given 4) (Given 1) (Dot (Given 4) (Given 3))
  (seen_square 1 2) one.
Lemma triangle_match : is_passage in_triangle Code.AcrossTriangle.u_x Code.AcrossTriangle.u_y Code.AcrossTriangle.u_z
  Code.AcrossTriangle.error Code.AcrossTriangle.is_known.
Proof. vm_compute. repeat split. Qed.

(* How much larger the area of q and the edge is than that of a corner and the next edge, squared. *)
Definition area_at_q := let v := flatten (Cross (Given 1) (Given 2)) in
  Add (Root (edot v v)) (Mul (Mul (in_roundoffs kAreaBound) (Root (square 1))) (Root (square 2))).
Definition area_at_corner i j := let v := flatten (Cross (Given i) (Given j)) in
  Sub (Root (edot v v)) (Mul (Mul (in_roundoffs kAreaBound) (Root (square i))) (Root (square j))).
Definition ratio_of_areas i j := Choose Less (Cst 0 0) (area_at_corner i j)
  (Div (Mul area_at_q area_at_q) (Mul (area_at_corner i j) (area_at_corner i j))) Infinite.
Definition squared e := Mul e e.

(* The next edge is p0 k, with k as point 3. Vector 3 leads from k to p1. *)
Definition corner_pairs := [(0, 2); (1, 2); (3, 1); (0, 1); (0, 3)]%nat.
Definition in_corner := passage corner_pairs (Given 3) (Given 4) (Given 5) (Dot (Given 4) (Given 3))
  (squared (Add (Root (seen_square 1 2)) (Root (square 3)))) (ratio_of_areas 4 3).
Lemma corner_match : is_passage in_corner Code.AcrossCorner.u_x Code.AcrossCorner.u_y Code.AcrossCorner.u_z
  Code.AcrossCorner.error Code.AcrossCorner.is_known.
Proof. vm_compute. repeat split. Qed.

(* The next edge leads from point 3 to point 4. Vectors 3 and 7 lead from them to p0, and vector 4 from point 4 to
   p1. *)
Definition polygon_pairs := [(0, 2); (1, 2); (3, 0); (4, 1); (0, 1); (3, 4); (4, 0)]%nat.
Definition in_polygon := passage polygon_pairs (VPlus (Given 3) (Given 4)) (Given 5) (Given 6)
  (Dot (Given 3) (Given 7))
  (squared (Add (Root (seen_square 1 2)) (Add (Root (square 3)) (Root (square 4))))) (ratio_of_areas 3 7).
Lemma polygon_match : is_passage in_polygon Code.AcrossPolygon.u_x Code.AcrossPolygon.u_y Code.AcrossPolygon.u_z
  Code.AcrossPolygon.error Code.AcrossPolygon.is_known.
Proof. vm_compute. repeat split. Qed.
