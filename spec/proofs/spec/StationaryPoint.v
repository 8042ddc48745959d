(* FC-IN-02 and 03, FC-DIST-01, FC-CRIT-01 to 03, FC-OUT-01: what a record of a list says, and when it is right.
   A row holds three numbers mantissa * 2^exponent, and doubles are such numbers. Its id is its place, from 0.
   Rows may be equal: the least id of equal rows is the name of their class. *)
From Coq Require Import Reals ZArith List Sorted.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.CriticalPoint spec.Face.
Import ListNotations.
Open Scope R_scope.

Record dyadic := Dyadic { mantissa : Z; exponent : Z }.
Record row := Row { row_x : dyadic; row_y : dyadic; row_z : dyadic }.
Definition value d := IZR (mantissa d) * powerRZ 2 (exponent d).
Definition row_point r := V (value (row_x r)) (value (row_y r)) (value (row_z r)).

(* P is the points of the rows, in their order. *)
Definition class_name P i p := point_at P i p /\ forall j, point_at P j p -> (i <= j)%Z.

(* K is the names of C(x), ascending, and C the points that they name. *)
Definition contact_names P x K C :=
  StronglySorted Z.lt K /\
  (forall i, In i K <-> exists p, class_name P i p /\ nearest P x p) /\
  Forall2 (class_name P) K C.

(* Of x with the contact set C: critical of index k, and regular of the kind (i, j). *)
Definition has_index C x k := in_relint C x /\ affine_dimension C k.
Definition has_regular_kind C x i j :=
  in_conv C x /\ ~ in_relint C x /\ affine_dimension C j /\
  exists F, face C F /\ in_relint F x /\ affine_dimension F i.

(* A record. Position and squared distance may be left out. *)
Inductive kind := Critical (index : nat) | Regular (face_dimension hull_dimension : nat).
Record ratio := Ratio { numerator : Z; denominator : Z }.
Record claim := Claim {
  claimed_contact : list Z;
  claimed_kind : kind;
  claimed_center : option (ratio * ratio * ratio);
  claimed_squared_distance : option ratio }.

Definition is_ratio a r := (0 < denominator a)%Z /\ IZR (numerator a) / IZR (denominator a) = r.
Definition has_kind C x k := match k with Critical i => has_index C x i | Regular i j => has_regular_kind C x i j end.
Definition has_center x c :=
  match c with None => True | Some (a, b, c) => is_ratio a (vx x) /\ is_ratio b (vy x) /\ is_ratio c (vz x) end.
Definition has_squared_distance P x d :=
  match d with None => True | Some a => forall p, nearest P x p -> is_ratio a (dist2 x p) end.

Definition right P q := exists x C,
  contact_names P x (claimed_contact q) C /\ has_kind C x (claimed_kind q) /\
  has_center x (claimed_center q) /\ has_squared_distance P x (claimed_squared_distance q).
