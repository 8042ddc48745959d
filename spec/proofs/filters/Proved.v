(* How large each constant has to be, in thousandths of the unit roundoff, rounded up: what is proved. *)
From Coq Require Import ZArith QArith Qround Bool List.
From Flowcert Require Import code.Expression code.generated.Constants filters.Terms filters.Filter filters.Predicates
  filters.Cells filters.Exact.

(* The bound is the constant times `share` times the value's size, or more. *)
Definition needed (value : term Scalar) bound (share : Q) : Z :=
  Qceiling (error (fun _ => unit) value * power (1 + 4 * unit) (degree value) * 1000
            / (power (1 - 2 * unit) (losses bound) * share * unit)).

Theorem angle_needs : needed angle angle_bound 1 = 5001%Z. Proof. by_computation. Qed.
Theorem orientation_needs : needed orientation orientation_bound 1 = 8415%Z. Proof. by_computation. Qed.
Theorem side_of_plane_needs : needed side_of_plane side_of_plane_bound 1 = 19829%Z. Proof. by_computation. Qed.
Theorem outside_sphere_needs : needed outside_sphere outside_sphere_bound 1 = 17415%Z. Proof. by_computation. Qed.
Theorem outside_circle_needs : needed (outside_circle 0) outside_circle_bound (1 # 2) = 22829%Z.
Proof. by_computation. Qed.
Theorem cell_angle_needs :
  List.fold_right Z.max 0%Z (List.map (fun v => needed v (with_unit cell_angle_bound) (1 # 4)) cell_angles) = 28001%Z.
Proof. by_computation. Qed.
Theorem cell_side_needs : needed s1 (with_unit (side_bound (Mul n1 n2))) 1 = 19829%Z. Proof. by_computation. Qed.
Theorem far_cell_side_needs : needed s0 (with_unit far_side_bound) (9 # 11) = 27902%Z. Proof. by_computation. Qed.

(* A cell's forms are exact up to this reach, and not beyond it. *)
Definition is_exact_cell reach := forallb (is_whole 3 reach) (cell_angles ++ sides).
Theorem exact_reach_allows : is_exact_cell 305 = true /\ is_exact_cell 306 = false. Proof. split; by_computation. Qed.
