(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.

(* (m, k) is m 2^k. *)
Definition kUnitRoundoff := (1, -53)%Z.
Definition kSmallestNorm := (6277101735386681, -192)%Z.
Definition kLargestNorm := (6462348535570529, 87)%Z.
Definition kAngleBound := (3, 1)%Z.
Definition kOrientationBound := (5, 1)%Z.
Definition kSideOfPlaneBound := (3, 3)%Z.
Definition kOutsideSphereBound := (5, 2)%Z.
Definition kOutsideCircleBound := (27, 0)%Z.
Definition kCellAngleBound := (1, 5)%Z.
Definition kCellSideBound := (1, 5)%Z.
Definition kFarCellSideBound := (1, 6)%Z.
Definition kExactReach := (125, 1)%Z.
Definition kDistanceBound := (1, 5)%Z.
Definition kPositionBound := (1, 3)%Z.
Definition kDistanceUnderflow := (4606887725612233, -547)%Z.
Definition kLargestDistance := (5503284107318959, 446)%Z.
Definition kWideBits := (41, 1)%Z.
Definition kNarrowBits := (61, 0)%Z.
Definition kSmallBits := (9, 1)%Z.
