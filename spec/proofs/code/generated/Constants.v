(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.

(* (m, k) is m 2^k. *)
Definition kUnitRoundoff := (1, -53)%Z.
Definition kSmallestNorm := (6277101735386681, -192)%Z.
Definition kLargestNorm := (6462348535570529, 87)%Z.
Definition kAngleBound := (3, 1)%Z.
Definition kOrientationBound := (9, 0)%Z.
Definition kSideOfPlaneBound := (5, 2)%Z.
Definition kOutsideSphereBound := (9, 1)%Z.
Definition kOutsideCircleBound := (23, 0)%Z.
Definition kCellAngleBound := (29, 0)%Z.
Definition kCellSideBound := (5, 2)%Z.
Definition kFarCellSideBound := (7, 2)%Z.
Definition kExactReach := (305, 0)%Z.
Definition kDistanceBound := (3, 2)%Z.
Definition kPositionBound := (1, 2)%Z.
Definition kDistanceUnderflow := (4606887725612233, -547)%Z.
Definition kLargestDistance := (5503284107318959, 446)%Z.
Definition kWideBits := (41, 1)%Z.
Definition kNarrowBits := (61, 0)%Z.
Definition kSmallBits := (9, 1)%Z.
