(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.
From Flowcert Require Import code.Expression.

Module Angle.
Definition x0 := Sub (Var 0) (Var 3).
Definition x1 := Sub (Var 1) (Var 4).
Definition x2 := Sub (Var 2) (Var 5).
Definition x3 := Root (Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2)).
Definition x4 := Sub (Var 6) (Var 3).
Definition x5 := Sub (Var 7) (Var 4).
Definition x6 := Sub (Var 8) (Var 5).
Definition x7 := Root (Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6)).
Definition x8 := Mul (Mul (Cst 3 (-52)) x3) x7.
Definition x9 := Add (Add (Mul x0 x4) (Mul x1 x5)) (Mul x2 x6).
Definition sign := If LessEqual (Cst 6277101735386681 (-192)) x3 (If LessEqual x3 (Cst 6462348535570529 87) (If
  LessEqual (Cst 6277101735386681 (-192)) x7 (If LessEqual x7 (Cst 6462348535570529 87) (If Less x8 x9 (Answer (Some
  Positive)) (If Less x9 (Neg x8) (Answer (Some Negative)) (Answer None))) (Answer None)) (Answer None)) (Answer None))
  (Answer None).
Definition unrounded_sign := If LessEqual (Cst 6277101735386681 (-192)) x3 (If LessEqual x3 (Cst 6462348535570529 87)
  (If LessEqual x3 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x7 (If LessEqual x7 (Cst 6462348535570529 87)
  (If LessEqual x7 (Var 15) (If Less (Cst 0 0) x9 (Answer (Some Positive)) (If Less x9 (Cst 0 0) (Answer (Some
  Negative)) (Answer (Some Zero)))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None).
Definition integers := Answer (Add (Add (Mul (Var 0) (Var 3)) (Mul (Var 1) (Var 4))) (Mul (Var 2) (Var 5))).
End Angle.

Module SideOfPlane.
Definition x0 := Sub (Var 3) (Var 0).
Definition x1 := Sub (Var 4) (Var 1).
Definition x2 := Sub (Var 5) (Var 2).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Root x3.
Definition x5 := Sub (Var 6) (Var 0).
Definition x6 := Sub (Var 7) (Var 1).
Definition x7 := Sub (Var 8) (Var 2).
Definition x8 := Add (Add (Mul x5 x5) (Mul x6 x6)) (Mul x7 x7).
Definition x9 := Root x8.
Definition x10 := Sub (Var 9) (Var 0).
Definition x11 := Sub (Var 10) (Var 1).
Definition x12 := Sub (Var 11) (Var 2).
Definition x13 := Add (Add (Mul x10 x10) (Mul x11 x11)) (Mul x12 x12).
Definition x14 := Root x13.
Definition x15 := Mul x4 x9.
Definition x16 := Mul (Mul (Mul (Cst 5 (-51)) x15) (Mul x15 x14)) (Add (Add x4 x9) x14).
Definition x17 := Sub (Mul x1 x7) (Mul x2 x6).
Definition x18 := Sub (Mul x2 x5) (Mul x0 x7).
Definition x19 := Sub (Mul x0 x6) (Mul x1 x5).
Definition x20 := Add (Add (Mul x17 (Add (Add (Mul x3 (Sub (Mul x6 x12) (Mul x7 x11))) (Mul x8 (Sub (Mul x11 x2) (Mul
  x12 x1)))) (Mul x13 x17))) (Mul x18 (Add (Add (Mul x3 (Sub (Mul x7 x10) (Mul x5 x12))) (Mul x8 (Sub (Mul x12 x0) (Mul
  x10 x2)))) (Mul x13 x18)))) (Mul x19 (Add (Add (Mul x3 (Sub (Mul x5 x11) (Mul x6 x10))) (Mul x8 (Sub (Mul x10 x1) (Mul
  x11 x0)))) (Mul x13 x19))).
Definition sign := If LessEqual (Cst 6277101735386681 (-192)) x4 (If LessEqual x4 (Cst 6462348535570529 87) (If
  LessEqual (Cst 6277101735386681 (-192)) x9 (If LessEqual x9 (Cst 6462348535570529 87) (If LessEqual (Cst
  6277101735386681 (-192)) x14 (If LessEqual x14 (Cst 6462348535570529 87) (If Less x16 x20 (Answer (Some Positive)) (If
  Less x20 (Neg x16) (Answer (Some Negative)) (Answer None))) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None).
Definition unrounded_sign := If LessEqual (Cst 6277101735386681 (-192)) x4 (If LessEqual x4 (Cst 6462348535570529 87)
  (If LessEqual x4 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x9 (If LessEqual x9 (Cst 6462348535570529 87)
  (If LessEqual x9 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x14 (If LessEqual x14 (Cst 6462348535570529 87)
  (If LessEqual x14 (Var 15) (If Less (Cst 0 0) x20 (Answer (Some Positive)) (If Less x20 (Cst 0 0) (Answer (Some
  Negative)) (Answer (Some Zero)))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None)) (Answer None).
Definition x21 := Wide (Sub (Mul (Var 1) (Var 5)) (Mul (Var 2) (Var 4))).
Definition x22 := Wide (Add (Add (Mul (Var 0) (Var 0)) (Mul (Var 1) (Var 1))) (Mul (Var 2) (Var 2))).
Definition x23 := Wide (Add (Add (Mul (Var 3) (Var 3)) (Mul (Var 4) (Var 4))) (Mul (Var 5) (Var 5))).
Definition x24 := Wide (Add (Add (Mul (Var 6) (Var 6)) (Mul (Var 7) (Var 7))) (Mul (Var 8) (Var 8))).
Definition x25 := Wide (Sub (Mul (Var 2) (Var 3)) (Mul (Var 0) (Var 5))).
Definition x26 := Wide (Sub (Mul (Var 0) (Var 4)) (Mul (Var 1) (Var 3))).
Definition integers := Answer (Add (Add (Mul x21 (Add (Add (Mul x22 (Wide (Sub (Mul (Var 4) (Var 8)) (Mul (Var 5) (Var
  7))))) (Mul x23 (Wide (Sub (Mul (Var 7) (Var 2)) (Mul (Var 8) (Var 1)))))) (Mul x24 x21))) (Mul x25 (Add (Add (Mul x22
  (Wide (Sub (Mul (Var 5) (Var 6)) (Mul (Var 3) (Var 8))))) (Mul x23 (Wide (Sub (Mul (Var 8) (Var 0)) (Mul (Var 6) (Var
  2)))))) (Mul x24 x25)))) (Mul x26 (Add (Add (Mul x22 (Wide (Sub (Mul (Var 3) (Var 7)) (Mul (Var 4) (Var 6))))) (Mul
  x23 (Wide (Sub (Mul (Var 6) (Var 1)) (Mul (Var 7) (Var 0)))))) (Mul x24 x26)))).
End SideOfPlane.

Module OutsideSphere.
Definition x0 := Sub (Var 3) (Var 0).
Definition x1 := Sub (Var 4) (Var 1).
Definition x2 := Sub (Var 5) (Var 2).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Root x3.
Definition x5 := Sub (Var 6) (Var 0).
Definition x6 := Sub (Var 7) (Var 1).
Definition x7 := Sub (Var 8) (Var 2).
Definition x8 := Add (Add (Mul x5 x5) (Mul x6 x6)) (Mul x7 x7).
Definition x9 := Root x8.
Definition x10 := Sub (Var 9) (Var 0).
Definition x11 := Sub (Var 10) (Var 1).
Definition x12 := Sub (Var 11) (Var 2).
Definition x13 := Add (Add (Mul x10 x10) (Mul x11 x11)) (Mul x12 x12).
Definition x14 := Root x13.
Definition x15 := Sub (Var 12) (Var 0).
Definition x16 := Sub (Var 13) (Var 1).
Definition x17 := Sub (Var 14) (Var 2).
Definition x18 := Add (Add (Mul x15 x15) (Mul x16 x16)) (Mul x17 x17).
Definition x19 := Root x18.
Definition x20 := Mul (Mul (Mul (Cst 9 (-52)) (Mul (Mul x4 x9) x14)) x19) (Add (Add (Add x4 x9) x14) x19).
Definition x21 := Sub (Mul x6 x12) (Mul x7 x11).
Definition x22 := Sub (Mul x7 x10) (Mul x5 x12).
Definition x23 := Sub (Mul x5 x11) (Mul x6 x10).
Definition x24 := Sub (Mul x18 (Add (Add (Mul x0 x21) (Mul x1 x22)) (Mul x2 x23))) (Add (Add (Mul (Add (Add (Mul x3 x21)
  (Mul x8 (Sub (Mul x11 x2) (Mul x12 x1)))) (Mul x13 (Sub (Mul x1 x7) (Mul x2 x6)))) x15) (Mul (Add (Add (Mul x3 x22)
  (Mul x8 (Sub (Mul x12 x0) (Mul x10 x2)))) (Mul x13 (Sub (Mul x2 x5) (Mul x0 x7)))) x16)) (Mul (Add (Add (Mul x3 x23)
  (Mul x8 (Sub (Mul x10 x1) (Mul x11 x0)))) (Mul x13 (Sub (Mul x0 x6) (Mul x1 x5)))) x17)).
Definition sign := If LessEqual (Cst 6277101735386681 (-192)) x4 (If LessEqual x4 (Cst 6462348535570529 87) (If
  LessEqual (Cst 6277101735386681 (-192)) x9 (If LessEqual x9 (Cst 6462348535570529 87) (If LessEqual (Cst
  6277101735386681 (-192)) x14 (If LessEqual x14 (Cst 6462348535570529 87) (If LessEqual (Cst 6277101735386681 (-192))
  x19 (If LessEqual x19 (Cst 6462348535570529 87) (If Less x20 x24 (Answer (Some Positive)) (If Less x24 (Neg x20)
  (Answer (Some Negative)) (Answer None))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None))
  (Answer None)) (Answer None)) (Answer None).
Definition unrounded_sign := If LessEqual (Cst 6277101735386681 (-192)) x4 (If LessEqual x4 (Cst 6462348535570529 87)
  (If LessEqual x4 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x9 (If LessEqual x9 (Cst 6462348535570529 87)
  (If LessEqual x9 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x14 (If LessEqual x14 (Cst 6462348535570529 87)
  (If LessEqual x14 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x19 (If LessEqual x19 (Cst 6462348535570529 87)
  (If LessEqual x19 (Var 15) (If Less (Cst 0 0) x24 (Answer (Some Positive)) (If Less x24 (Cst 0 0) (Answer (Some
  Negative)) (Answer (Some Zero)))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None).
Definition x25 := Wide (Sub (Mul (Var 4) (Var 8)) (Mul (Var 5) (Var 7))).
Definition x26 := Wide (Sub (Mul (Var 5) (Var 6)) (Mul (Var 3) (Var 8))).
Definition x27 := Wide (Sub (Mul (Var 3) (Var 7)) (Mul (Var 4) (Var 6))).
Definition x28 := Wide (Add (Add (Mul (Var 0) (Var 0)) (Mul (Var 1) (Var 1))) (Mul (Var 2) (Var 2))).
Definition x29 := Wide (Add (Add (Mul (Var 3) (Var 3)) (Mul (Var 4) (Var 4))) (Mul (Var 5) (Var 5))).
Definition x30 := Wide (Add (Add (Mul (Var 6) (Var 6)) (Mul (Var 7) (Var 7))) (Mul (Var 8) (Var 8))).
Definition integers := Answer (Sub (Mul (Wide (Add (Add (Mul (Var 9) (Var 9)) (Mul (Var 10) (Var 10))) (Mul (Var 11)
  (Var 11)))) (Add (Add (Mul (Wide (Var 0)) x25) (Mul (Wide (Var 1)) x26)) (Mul (Wide (Var 2)) x27))) (Add (Add (Mul
  (Add (Add (Mul x28 x25) (Mul x29 (Wide (Sub (Mul (Var 7) (Var 2)) (Mul (Var 8) (Var 1)))))) (Mul x30 (Wide (Sub (Mul
  (Var 1) (Var 5)) (Mul (Var 2) (Var 4)))))) (Wide (Var 9))) (Mul (Add (Add (Mul x28 x26) (Mul x29 (Wide (Sub (Mul (Var
  8) (Var 0)) (Mul (Var 6) (Var 2)))))) (Mul x30 (Wide (Sub (Mul (Var 2) (Var 3)) (Mul (Var 0) (Var 5)))))) (Wide (Var
  10)))) (Mul (Add (Add (Mul x28 x27) (Mul x29 (Wide (Sub (Mul (Var 6) (Var 1)) (Mul (Var 7) (Var 0)))))) (Mul x30 (Wide
  (Sub (Mul (Var 0) (Var 4)) (Mul (Var 1) (Var 3)))))) (Wide (Var 11))))).
End OutsideSphere.

Module Orientation.
Definition x0 := Sub (Var 3) (Var 0).
Definition x1 := Sub (Var 4) (Var 1).
Definition x2 := Sub (Var 5) (Var 2).
Definition x3 := Root (Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2)).
Definition x4 := Sub (Var 6) (Var 0).
Definition x5 := Sub (Var 7) (Var 1).
Definition x6 := Sub (Var 8) (Var 2).
Definition x7 := Root (Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6)).
Definition x8 := Sub (Var 9) (Var 0).
Definition x9 := Sub (Var 10) (Var 1).
Definition x10 := Sub (Var 11) (Var 2).
Definition x11 := Root (Add (Add (Mul x8 x8) (Mul x9 x9)) (Mul x10 x10)).
Definition x12 := Mul (Mul (Mul (Cst 9 (-53)) x3) x7) x11.
Definition x13 := Add (Add (Mul x0 (Sub (Mul x5 x10) (Mul x6 x9))) (Mul x1 (Sub (Mul x6 x8) (Mul x4 x10)))) (Mul x2 (Sub
  (Mul x4 x9) (Mul x5 x8))).
Definition sign := If LessEqual (Cst 6277101735386681 (-192)) x3 (If LessEqual x3 (Cst 6462348535570529 87) (If
  LessEqual (Cst 6277101735386681 (-192)) x7 (If LessEqual x7 (Cst 6462348535570529 87) (If LessEqual (Cst
  6277101735386681 (-192)) x11 (If LessEqual x11 (Cst 6462348535570529 87) (If Less x12 x13 (Answer (Some Positive)) (If
  Less x13 (Neg x12) (Answer (Some Negative)) (Answer None))) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None).
Definition unrounded_sign := If LessEqual (Cst 6277101735386681 (-192)) x3 (If LessEqual x3 (Cst 6462348535570529 87)
  (If LessEqual x3 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x7 (If LessEqual x7 (Cst 6462348535570529 87)
  (If LessEqual x7 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x11 (If LessEqual x11 (Cst 6462348535570529 87)
  (If LessEqual x11 (Var 15) (If Less (Cst 0 0) x13 (Answer (Some Positive)) (If Less x13 (Cst 0 0) (Answer (Some
  Negative)) (Answer (Some Zero)))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None)) (Answer None).
Definition integers := Answer (Add (Add (Mul (Wide (Var 0)) (Wide (Sub (Mul (Var 4) (Var 8)) (Mul (Var 5) (Var 7)))))
  (Mul (Wide (Var 1)) (Wide (Sub (Mul (Var 5) (Var 6)) (Mul (Var 3) (Var 8)))))) (Mul (Wide (Var 2)) (Wide (Sub (Mul
  (Var 3) (Var 7)) (Mul (Var 4) (Var 6)))))).
End Orientation.

Module OutsideCircle.
Definition x0 := Sub (Var 0) (Var 6).
Definition x1 := Sub (Var 1) (Var 7).
Definition x2 := Sub (Var 2) (Var 8).
Definition x3 := Root (Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2)).
Definition x4 := Sub (Var 3) (Var 6).
Definition x5 := Sub (Var 4) (Var 7).
Definition x6 := Sub (Var 5) (Var 8).
Definition x7 := Root (Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6)).
Definition x8 := Sub (Var 0) (Var 9).
Definition x9 := Sub (Var 1) (Var 10).
Definition x10 := Sub (Var 2) (Var 11).
Definition x11 := Root (Add (Add (Mul x8 x8) (Mul x9 x9)) (Mul x10 x10)).
Definition x12 := Sub (Var 3) (Var 9).
Definition x13 := Sub (Var 4) (Var 10).
Definition x14 := Sub (Var 5) (Var 11).
Definition x15 := Root (Add (Add (Mul x12 x12) (Mul x13 x13)) (Mul x14 x14)).
Definition x16 := Abs (Sub (Mul x2 x4) (Mul x0 x6)).
Definition x17 := Abs (Sub (Mul x1 x6) (Mul x2 x5)).
Definition x18 := Abs (Sub (Mul x0 x5) (Mul x1 x4)).
Definition x19 := Mul (Mul (Cst 23 (-53)) (Mul x3 x7)) (Mul x11 x15).
Definition x20 := Add (Add (Mul x0 x4) (Mul x1 x5)) (Mul x2 x6).
Definition x21 := Add (Add (Mul x8 x12) (Mul x9 x13)) (Mul x10 x14).
Definition x22 := Add (Mul x20 (Abs (Sub (Mul x9 x14) (Mul x10 x13)))) (Mul x21 x17).
Definition x23 := Neg x19.
Definition x24 := Add (Mul x20 (Abs (Sub (Mul x10 x12) (Mul x8 x14)))) (Mul x21 x16).
Definition x25 := Add (Mul x20 (Abs (Sub (Mul x8 x13) (Mul x9 x12)))) (Mul x21 x18).
Definition sign := If LessEqual (Cst 6277101735386681 (-192)) x3 (If LessEqual x3 (Cst 6462348535570529 87) (If
  LessEqual (Cst 6277101735386681 (-192)) x7 (If LessEqual x7 (Cst 6462348535570529 87) (If LessEqual (Cst
  6277101735386681 (-192)) x11 (If LessEqual x11 (Cst 6462348535570529 87) (If LessEqual (Cst 6277101735386681 (-192))
  x15 (If LessEqual x15 (Cst 6462348535570529 87) (If LessEqual x16 x17 (If LessEqual x18 x17 (If Less x19 x22 (Answer
  (Some Positive)) (If Less x22 x23 (Answer (Some Negative)) (Answer None))) (If LessEqual x18 x16 (If Less x19 x24
  (Answer (Some Positive)) (If Less x24 x23 (Answer (Some Negative)) (Answer None))) (If Less x19 x25 (Answer (Some
  Positive)) (If Less x25 x23 (Answer (Some Negative)) (Answer None))))) (If LessEqual x18 x16 (If Less x19 x24 (Answer
  (Some Positive)) (If Less x24 x23 (Answer (Some Negative)) (Answer None))) (If Less x19 x25 (Answer (Some Positive))
  (If Less x25 x23 (Answer (Some Negative)) (Answer None))))) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None)) (Answer None)) (Answer None).
Definition unrounded_sign := If LessEqual (Cst 6277101735386681 (-192)) x3 (If LessEqual x3 (Cst 6462348535570529 87)
  (If LessEqual x3 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x7 (If LessEqual x7 (Cst 6462348535570529 87)
  (If LessEqual x7 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x11 (If LessEqual x11 (Cst 6462348535570529 87)
  (If LessEqual x11 (Var 15) (If LessEqual (Cst 6277101735386681 (-192)) x15 (If LessEqual x15 (Cst 6462348535570529 87)
  (If LessEqual x15 (Var 15) (If LessEqual x16 x17 (If LessEqual x18 x17 (If Less (Cst 0 0) x22 (Answer (Some Positive))
  (If Less x22 (Cst 0 0) (Answer (Some Negative)) (Answer (Some Zero)))) (If LessEqual x18 x16 (If Less (Cst 0 0) x24
  (Answer (Some Positive)) (If Less x24 (Cst 0 0) (Answer (Some Negative)) (Answer (Some Zero)))) (If Less (Cst 0 0) x25
  (Answer (Some Positive)) (If Less x25 (Cst 0 0) (Answer (Some Negative)) (Answer (Some Zero)))))) (If LessEqual x18
  x16 (If Less (Cst 0 0) x24 (Answer (Some Positive)) (If Less x24 (Cst 0 0) (Answer (Some Negative)) (Answer (Some
  Zero)))) (If Less (Cst 0 0) x25 (Answer (Some Positive)) (If Less x25 (Cst 0 0) (Answer (Some Negative)) (Answer (Some
  Zero)))))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None))
  (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None).
Definition x26 := Abs (Wide (Sub (Mul (Var 2) (Var 3)) (Mul (Var 0) (Var 5)))).
Definition x27 := Abs (Wide (Sub (Mul (Var 1) (Var 5)) (Mul (Var 2) (Var 4)))).
Definition x28 := Abs (Wide (Sub (Mul (Var 0) (Var 4)) (Mul (Var 1) (Var 3)))).
Definition x29 := Wide (Add (Add (Mul (Var 0) (Var 3)) (Mul (Var 1) (Var 4))) (Mul (Var 2) (Var 5))).
Definition x30 := Wide (Add (Add (Mul (Var 6) (Var 9)) (Mul (Var 7) (Var 10))) (Mul (Var 8) (Var 11))).
Definition x31 := Add (Mul x29 (Abs (Wide (Sub (Mul (Var 8) (Var 9)) (Mul (Var 6) (Var 11)))))) (Mul x30 x26).
Definition x32 := Add (Mul x29 (Abs (Wide (Sub (Mul (Var 6) (Var 10)) (Mul (Var 7) (Var 9)))))) (Mul x30 x28).
Definition integers := If LessEqual x26 x27 (If LessEqual x28 x27 (Answer (Add (Mul x29 (Abs (Wide (Sub (Mul (Var 7)
  (Var 11)) (Mul (Var 8) (Var 10)))))) (Mul x30 x27))) (If LessEqual x28 x26 (Answer x31) (Answer x32))) (If LessEqual
  x28 x26 (Answer x31) (Answer x32)).
End OutsideCircle.
