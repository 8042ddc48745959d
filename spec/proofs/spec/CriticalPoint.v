(* FC-DIST-01, FC-CRIT-02: contact sets and critical points. P is the merged input, ids are its positions. *)
From Coq Require Import Reals ZArith List.
From Flowcert Require Import algebra.Vector3 spec.Hull.
Import ListNotations.
Open Scope R_scope.

Definition point_at (P : list vec) (i : Z) (p : vec) := (0 <= i)%Z /\ nth_error P (Z.to_nat i) = Some p.
Definition nearest P x p := In p P /\ forall q, In q P -> dist2 x p <= dist2 x q.
Definition is_contact P x i := exists p, point_at P i p /\ forall q, In q P -> dist2 x p <= dist2 x q.
Definition contact_set P x K := NoDup K /\ forall i, In i K <-> is_contact P x i.

(* The dimension of aff C: a basis of k of the differences to one of its points. *)
Definition independent B := forall c, length c = length B -> comb c B = vzero -> Forall (fun a => a = 0) c.
Definition affine_dimension C k := exists p0 B,
  In p0 C /\ length B = k /\ independent B /\
  (forall b, In b B -> exists p, In p C /\ b = vsub p p0) /\
  (forall p, In p C -> in_span B (vsub p p0)).

Definition critical P x K k :=
  contact_set P x K /\
  exists C, Forall2 (point_at P) K C /\ in_relint C x /\ affine_dimension C k.
