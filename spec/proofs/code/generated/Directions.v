(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.
From Flowcert Require Import code.Expression.

Module Approach.
Definition x0 := Sub (Var 6) (Var 0).
Definition x1 := Sub (Var 7) (Var 1).
Definition x2 := Sub (Var 8) (Var 2).
Definition x3 := Sub (Var 6) (Var 3).
Definition x4 := Sub (Var 7) (Var 4).
Definition x5 := Sub (Var 8) (Var 5).
Definition x6 := Mul (Cst 1 1) (Add (Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2)) (Add (Add (Mul x3 x3) (Mul x4 x4))
  (Mul x5 x5))).
Definition x7 := Mul (Add (Var 21) (Cst 5 (-51))) (Root x6).
Definition x8 := Add (Add (Mul (Var 18) (Add x0 x3)) (Mul (Var 19) (Add x1 x4))) (Mul (Var 20) (Add x2 x5)).
Definition sign := If Less (Var 21) (Cst 1 0) (If LessEqual (Cst 8424983333484575 (-219)) x6 (If LessEqual x6 (Cst
  2407412430484045 115) (If Less x7 x8 (Answer (Some Positive)) (If Less x8 (Neg x7) (Answer (Some Negative)) (Answer
  None))) (Answer None)) (Answer None)) (Answer None).
End Approach.

Module Order.
Definition x0 := Add (Mul (Cst 1 (-2)) (Var 21)) (Cst 7 (-53)).
Definition x1 := Sub (Var 6) (Var 0).
Definition x2 := Sub (Var 7) (Var 1).
Definition x3 := Sub (Var 8) (Var 2).
Definition x4 := Sub (Var 6) (Var 3).
Definition x5 := Sub (Var 7) (Var 4).
Definition x6 := Sub (Var 8) (Var 5).
Definition x7 := Mul (Cst 1 1) (Add (Add (Add (Mul x1 x1) (Mul x2 x2)) (Mul x3 x3)) (Add (Add (Mul x4 x4) (Mul x5 x5))
  (Mul x6 x6))).
Definition x8 := Sub (Var 9) (Var 0).
Definition x9 := Sub (Var 10) (Var 1).
Definition x10 := Sub (Var 11) (Var 2).
Definition x11 := Sub (Var 9) (Var 3).
Definition x12 := Sub (Var 10) (Var 4).
Definition x13 := Sub (Var 11) (Var 5).
Definition x14 := Mul (Cst 1 1) (Add (Add (Add (Mul x8 x8) (Mul x9 x9)) (Mul x10 x10)) (Add (Add (Mul x11 x11) (Mul x12
  x12)) (Mul x13 x13))).
Definition x15 := Sub (Mul (Add (Add (Mul x8 x11) (Mul x9 x12)) (Mul x10 x13)) (Add (Add (Mul (Var 18) (Add x1 x4)) (Mul
  (Var 19) (Add x2 x5))) (Mul (Var 20) (Add x3 x6)))) (Mul (Add (Add (Mul x1 x4) (Mul x2 x5)) (Mul x3 x6)) (Add (Add
  (Mul (Var 18) (Add x8 x11)) (Mul (Var 19) (Add x9 x12))) (Mul (Var 20) (Add x10 x13)))).
Definition sign := If Less (Var 21) (Cst 1 0) (If Less (Mul (Mul (Mul (Cst 1 1) x0) x0) (Mul (Mul x7 x14) (Add x7 x14)))
  (Mul x15 x15) (If LessEqual (Cst 8424983333484575 (-219)) x7 (If LessEqual x7 (Cst 2407412430484045 115) (If LessEqual
  (Cst 8424983333484575 (-219)) x14 (If LessEqual x14 (Cst 2407412430484045 115) (If Less (Cst 0 0) x15 (Answer (Some
  Positive)) (Answer (Some Negative))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None))
  (Answer None).
End Order.

Module Normal.
Definition x0 := Sub (Var 9) (Var 6).
Definition x1 := Sub (Var 10) (Var 7).
Definition x2 := Sub (Var 11) (Var 8).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Sub (Var 12) (Var 6).
Definition x5 := Sub (Var 13) (Var 7).
Definition x6 := Sub (Var 14) (Var 8).
Definition x7 := Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6).
Definition x8 := Mul (Mul (Add (Var 21) (Cst 23 (-53))) (Root x3)) (Root x7).
Definition x9 := Add (Add (Mul (Var 18) (Sub (Mul x1 x6) (Mul x2 x5))) (Mul (Var 19) (Sub (Mul x2 x4) (Mul x0 x6))))
  (Mul (Var 20) (Sub (Mul x0 x5) (Mul x1 x4))).
Definition sign := If Less (Var 21) (Cst 1 0) (If LessEqual (Cst 8424983333484575 (-219)) x3 (If LessEqual x3 (Cst
  2407412430484045 115) (If LessEqual (Cst 8424983333484575 (-219)) x7 (If LessEqual x7 (Cst 2407412430484045 115) (If
  Less x8 x9 (Answer (Some Positive)) (If Less x9 (Neg x8) (Answer (Some Negative)) (Answer None))) (Answer None))
  (Answer None)) (Answer None)) (Answer None)) (Answer None).
End Normal.

Module OfVector.
Definition x0 := Div (Cst 1 0) (Root (Add (Add (Mul (Var 0) (Var 0)) (Mul (Var 1) (Var 1))) (Mul (Var 2) (Var 2)))).
Definition x1 := Div (Add (Add (Mul (Var 0) (Var 3)) (Mul (Var 1) (Var 4))) (Mul (Var 2) (Var 5))) (Add (Add (Mul (Var
  3) (Var 3)) (Mul (Var 4) (Var 4))) (Mul (Var 5) (Var 5))).
Definition x2 := Mul (Var 6) x0.
Definition u_x := Mul x0 (Sub (Var 0) (Mul x1 (Var 3))).
Definition u_y := Mul x0 (Sub (Var 1) (Mul x1 (Var 4))).
Definition u_z := Mul x0 (Sub (Var 2) (Mul x1 (Var 5))).
Definition error := Mul x2 (Add (Cst 1 0) (Mul (Cst 1 1) x2)).
Definition x3 := Add (Add (Mul (Var 3) (Var 3)) (Mul (Var 4) (Var 4))) (Mul (Var 5) (Var 5)).
Definition is_known := If LessEqual (Cst 8424983333484575 (-219)) x3 (If LessEqual x3 (Cst 2407412430484045 115) (If
  Less (Cst 0 0) x0 (If Less x2 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer None))
  (Answer None).
End OfVector.

Module StartAtVertex.
Definition x0 := Sub (Var 9) (Var 6).
Definition x1 := Sub (Var 10) (Var 7).
Definition x2 := Sub (Var 11) (Var 8).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Sub (Var 13) (Var 7).
Definition x5 := Sub (Var 17) (Var 8).
Definition x6 := Sub (Var 14) (Var 8).
Definition x7 := Sub (Var 16) (Var 7).
Definition x8 := Sub (Mul x4 x5) (Mul x6 x7).
Definition x9 := Sub (Var 12) (Var 6).
Definition x10 := Add (Add (Mul x9 x9) (Mul x4 x4)) (Mul x6 x6).
Definition x11 := Sub (Var 15) (Var 6).
Definition x12 := Add (Add (Mul x11 x11) (Mul x7 x7)) (Mul x5 x5).
Definition x13 := Sub (Mul x6 x11) (Mul x9 x5).
Definition x14 := Sub (Mul x9 x7) (Mul x4 x11).
Definition x15 := Add (Add (Mul x0 x8) (Mul x1 x13)) (Mul x2 x14).
Definition x16 := Sub (Var 6) (Var 0).
Definition x17 := Sub (Var 6) (Var 3).
Definition x18 := Add (Add (Add (Mul x3 x8) (Mul x10 (Sub (Mul x7 x2) (Mul x5 x1)))) (Mul x12 (Sub (Mul x1 x6) (Mul x2
  x4)))) (Mul x15 (Add x16 x17)).
Definition x19 := Sub (Var 7) (Var 1).
Definition x20 := Sub (Var 7) (Var 4).
Definition x21 := Add (Add (Add (Mul x3 x13) (Mul x10 (Sub (Mul x5 x0) (Mul x11 x2)))) (Mul x12 (Sub (Mul x2 x9) (Mul x0
  x6)))) (Mul x15 (Add x19 x20)).
Definition x22 := Sub (Var 8) (Var 2).
Definition x23 := Sub (Var 8) (Var 5).
Definition x24 := Add (Add (Add (Mul x3 x14) (Mul x10 (Sub (Mul x11 x1) (Mul x7 x0)))) (Mul x12 (Sub (Mul x0 x4) (Mul x1
  x9)))) (Mul x15 (Add x22 x23)).
Definition x25 := Div (Cst 1 0) (Root (Add (Add (Mul x18 x18) (Mul x21 x21)) (Mul x24 x24))).
Definition x26 := Sub (Var 3) (Var 0).
Definition x27 := Sub (Var 4) (Var 1).
Definition x28 := Sub (Var 5) (Var 2).
Definition x29 := Div (Add (Add (Mul x18 x26) (Mul x21 x27)) (Mul x24 x28)) (Add (Add (Mul x26 x26) (Mul x27 x27)) (Mul
  x28 x28)).
Definition x30 := Root x3.
Definition x31 := Root x10.
Definition x32 := Root x12.
Definition x33 := Mul (Mul (Mul (Cst 11 (-52)) (Mul (Mul x30 x31) x32)) (Add (Add (Add (Add x30 x31) x32) (Root (Add
  (Add (Mul x16 x16) (Mul x19 x19)) (Mul x22 x22)))) (Root (Add (Add (Mul x17 x17) (Mul x20 x20)) (Mul x23 x23))))) x25.
Definition u_x := Mul x25 (Sub x18 (Mul x29 x26)).
Definition u_y := Mul x25 (Sub x21 (Mul x29 x27)).
Definition u_z := Mul x25 (Sub x24 (Mul x29 x28)).
Definition error := Mul x33 (Add (Cst 1 0) (Mul (Cst 1 1) x33)).
Definition x34 := Choose Less x31 x30 x31 x30.
Definition x35 := Choose Less x32 x34 x32 x34.
Definition x36 := Mul x35 x35.
Definition x37 := Choose Less x30 x31 x31 x30.
Definition x38 := Choose Less x37 x32 x32 x37.
Definition x39 := Mul x38 x38.
Definition x40 := Add (Add (Mul x26 x26) (Mul x27 x27)) (Mul x28 x28).
Definition is_known := If LessEqual (Cst 8424983333484575 (-219)) x36 (If LessEqual x36 (Cst 2407412430484045 115) (If
  LessEqual (Cst 8424983333484575 (-219)) x39 (If LessEqual x39 (Cst 2407412430484045 115) (If LessEqual (Cst
  8424983333484575 (-219)) x40 (If LessEqual x40 (Cst 2407412430484045 115) (If Less (Cst 0 0) x25 (If Less x33 (Cst 1
  (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None).
End StartAtVertex.

Module StartAtSide.
Definition x0 := Sub (Var 6) (Var 0).
Definition x1 := Sub (Var 7) (Var 1).
Definition x2 := Sub (Var 8) (Var 2).
Definition x3 := Choose Less (Cst 0 0) (Add (Add (Mul x0 (Sub (Var 6) (Var 3))) (Mul x1 (Sub (Var 7) (Var 4)))) (Mul x2
  (Sub (Var 8) (Var 5)))) (Cst 1 0) (Cst (-1) 0).
Definition x4 := Sub (Var 3) (Var 0).
Definition x5 := Sub (Var 4) (Var 1).
Definition x6 := Sub (Var 5) (Var 2).
Definition x7 := Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6).
Definition x8 := Add (Add (Mul x0 x4) (Mul x1 x5)) (Mul x2 x6).
Definition x9 := Mul x3 (Sub (Mul x7 x0) (Mul x8 x4)).
Definition x10 := Mul x3 (Sub (Mul x7 x1) (Mul x8 x5)).
Definition x11 := Mul x3 (Sub (Mul x7 x2) (Mul x8 x6)).
Definition x12 := Div (Cst 1 0) (Root (Add (Add (Mul x9 x9) (Mul x10 x10)) (Mul x11 x11))).
Definition x13 := Div (Add (Add (Mul x9 x4) (Mul x10 x5)) (Mul x11 x6)) x7.
Definition x14 := Mul (Mul (Mul (Cst 3 (-50)) x7) (Root (Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2)))) x12.
Definition u_x := Mul x12 (Sub x9 (Mul x13 x4)).
Definition u_y := Mul x12 (Sub x10 (Mul x13 x5)).
Definition u_z := Mul x12 (Sub x11 (Mul x13 x6)).
Definition error := Mul x14 (Add (Cst 1 0) (Mul (Cst 1 1) x14)).
Definition x15 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x16 := Sub (Var 6) (Var 3).
Definition x17 := Sub (Var 7) (Var 4).
Definition x18 := Sub (Var 8) (Var 5).
Definition is_known := If LessEqual (Cst 8424983333484575 (-219)) x15 (If LessEqual x15 (Cst 2407412430484045 115) (If
  Less (Mul (Cst 1 (-51)) (Add x15 (Add (Add (Mul x16 x16) (Mul x17 x17)) (Mul x18 x18)))) (Abs (Add (Add (Mul x0 x16)
  (Mul x1 x17)) (Mul x2 x18))) (If LessEqual (Cst 8424983333484575 (-219)) x7 (If LessEqual x7 (Cst 2407412430484045
  115) (If Less (Cst 0 0) x12 (If Less x14 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None)) (Answer None)) (Answer None).
End StartAtSide.

Module StartAtCircle.
Definition x0 := Sub (Var 10) (Var 7).
Definition x1 := Sub (Var 14) (Var 8).
Definition x2 := Sub (Var 11) (Var 8).
Definition x3 := Sub (Var 13) (Var 7).
Definition x4 := Sub (Mul x0 x1) (Mul x2 x3).
Definition x5 := Sub (Var 12) (Var 6).
Definition x6 := Sub (Var 9) (Var 6).
Definition x7 := Sub (Mul x2 x5) (Mul x6 x1).
Definition x8 := Sub (Mul x6 x3) (Mul x0 x5).
Definition x9 := Add (Add (Mul x4 x4) (Mul x7 x7)) (Mul x8 x8).
Definition x10 := Sub (Var 6) (Var 0).
Definition x11 := Sub (Var 6) (Var 3).
Definition x12 := Add (Add (Mul x6 x6) (Mul x0 x0)) (Mul x2 x2).
Definition x13 := Add (Add (Mul x5 x5) (Mul x3 x3)) (Mul x1 x1).
Definition x14 := Sub (Mul x12 x3) (Mul x13 x0).
Definition x15 := Sub (Mul x12 x1) (Mul x13 x2).
Definition x16 := Add (Mul x9 (Add x10 x11)) (Sub (Mul x14 x8) (Mul x15 x7)).
Definition x17 := Sub (Var 7) (Var 1).
Definition x18 := Sub (Var 7) (Var 4).
Definition x19 := Sub (Mul x12 x5) (Mul x13 x6).
Definition x20 := Add (Mul x9 (Add x17 x18)) (Sub (Mul x15 x4) (Mul x19 x8)).
Definition x21 := Sub (Var 8) (Var 2).
Definition x22 := Sub (Var 8) (Var 5).
Definition x23 := Add (Mul x9 (Add x21 x22)) (Sub (Mul x19 x7) (Mul x14 x4)).
Definition x24 := Div (Cst 1 0) (Root (Add (Add (Mul x16 x16) (Mul x20 x20)) (Mul x23 x23))).
Definition x25 := Sub (Var 3) (Var 0).
Definition x26 := Sub (Var 4) (Var 1).
Definition x27 := Sub (Var 5) (Var 2).
Definition x28 := Div (Add (Add (Mul x16 x25) (Mul x20 x26)) (Mul x23 x27)) (Add (Add (Mul x25 x25) (Mul x26 x26)) (Mul
  x27 x27)).
Definition x29 := Mul (Mul (Mul (Mul (Cst 3 (-50)) x12) x13) (Add (Add (Add (Root x12) (Root x13)) (Root (Add (Add (Mul
  x10 x10) (Mul x17 x17)) (Mul x21 x21)))) (Root (Add (Add (Mul x11 x11) (Mul x18 x18)) (Mul x22 x22))))) x24.
Definition u_x := Mul x24 (Sub x16 (Mul x28 x25)).
Definition u_y := Mul x24 (Sub x20 (Mul x28 x26)).
Definition u_z := Mul x24 (Sub x23 (Mul x28 x27)).
Definition error := Mul x29 (Add (Cst 1 0) (Mul (Cst 1 1) x29)).
Definition x30 := Add (Add (Mul x25 x25) (Mul x26 x26)) (Mul x27 x27).
Definition is_known := If LessEqual (Cst 8424983333484575 (-219)) x12 (If LessEqual x12 (Cst 2407412430484045 115) (If
  LessEqual (Cst 8424983333484575 (-219)) x13 (If LessEqual x13 (Cst 2407412430484045 115) (If LessEqual (Cst
  8424983333484575 (-219)) x30 (If LessEqual x30 (Cst 2407412430484045 115) (If Less (Cst 0 0) x24 (If Less x29 (Cst 1
  (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None).
End StartAtCircle.

Module Behind.
Definition x0 := Add (Add (Mul (Var 0) (Var 6)) (Mul (Var 1) (Var 7))) (Mul (Var 2) (Var 8)).
Definition x1 := Mul (Cst 1 1) (Var 9).
Definition x2 := Add (Mul x0 (Var 12)) (Mul x1 (Var 0)).
Definition x3 := Add (Mul x0 (Var 13)) (Mul x1 (Var 1)).
Definition x4 := Add (Mul x0 (Var 14)) (Mul x1 (Var 2)).
Definition x5 := Div (Cst 1 0) (Root (Add (Add (Mul x2 x2) (Mul x3 x3)) (Mul x4 x4))).
Definition x6 := Mul (Mul (Cst 1 1) (Cst 1 (-53))) (Var 10).
Definition x7 := Choose Less (Mul (Add (Var 3) (Mul (Cst 5 2) (Cst 1 (-53)))) (Root (Var 10))) x0 x5 (Choose Less x6
  (Var 9) x5 (Neg x5)).
Definition x8 := Add (Add (Mul (Var 21) (Var 21)) (Mul (Var 22) (Var 22))) (Mul (Var 23) (Var 23)).
Definition x9 := Div (Add (Add (Mul x2 (Var 21)) (Mul x3 (Var 22))) (Mul x4 (Var 23))) x8.
Definition x10 := Add (Abs (Var 9)) x6.
Definition x11 := Mul (Add (Abs (Var 15)) (Mul (Mul (Cst 3 1) (Cst 1 (-53))) (Var 16))) (Root (Div (Mul (Var 17) x8)
  (Add (Add (Mul (Var 18) (Var 18)) (Mul (Var 19) (Var 19))) (Mul (Var 20) (Var 20))))).
Definition x12 := Mul (Mul (Mul (Mul (Cst 1 2) x10) x11) x5) x5.
Definition x13 := Mul (Mul (Mul (Cst 37 0) (Cst 1 (-53))) (Var 16)) x5.
Definition u_x := Mul x7 (Sub x2 (Mul x9 (Var 21))).
Definition u_y := Mul x7 (Sub x3 (Mul x9 (Var 22))).
Definition u_z := Mul x7 (Sub x4 (Mul x9 (Var 23))).
Definition error := Mul (Add (Mul x12 (Var 3)) x13) (Add (Cst 1 0) (Mul (Cst 1 3) (Add (Mul (Add x12 (Mul (Mul (Cst 1 1)
  (Choose Less x10 x11 x11 x10)) x5)) (Var 3)) x13))).
Definition x14 := Add (Add (Mul (Var 18) (Var 18)) (Mul (Var 19) (Var 19))) (Mul (Var 20) (Var 20)).
Definition x15 := Mul (Add (Var 3) (Mul (Cst 5 2) (Cst 1 (-53)))) (Root (Var 10)).
Definition x16 := Add (Mul (Add x12 (Mul (Mul (Cst 1 1) (Choose Less x10 x11 x11 x10)) x5)) (Var 3)) x13.
Definition is_known := If Less (Var 3) (Cst 1 0) (If LessEqual (Cst 8424983333484575 (-219)) (Var 10) (If LessEqual (Var
  10) (Cst 2407412430484045 115) (If LessEqual (Cst 8424983333484575 (-219)) x14 (If LessEqual x14 (Cst 2407412430484045
  115) (If LessEqual (Cst 8424983333484575 (-219)) x8 (If LessEqual x8 (Cst 2407412430484045 115) (If Less x15 x0 (If
  Less (Cst 0 0) x5 (If Less x16 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x6 (Var 9)
  (If Less (Cst 0 0) x5 (If Less x16 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x0
  (Neg x15) (If Less (Cst 0 0) x5 (If Less x16 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If
  Less (Var 9) (Neg x6) (If Less (Cst 0 0) x5 (If Less x16 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer
  None)) (Answer None))))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None))
  (Answer None).
End Behind.

Module AcrossTriangle.
Definition x0 := Sub (Var 6) (Var 0).
Definition x1 := Sub (Var 7) (Var 1).
Definition x2 := Sub (Var 8) (Var 2).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Sub (Var 6) (Var 3).
Definition x5 := Sub (Var 7) (Var 4).
Definition x6 := Sub (Var 8) (Var 5).
Definition x7 := Mul (Cst 1 1) (Add x3 (Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6))).
Definition x8 := Add (Add (Mul (Var 18) (Add x0 x4)) (Mul (Var 19) (Add x1 x5))) (Mul (Var 20) (Add x2 x6)).
Definition x9 := Sub (Var 3) (Var 6).
Definition x10 := Add (Add (Mul x0 x4) (Mul x1 x5)) (Mul x2 x6).
Definition x11 := Mul (Cst 1 1) x10.
Definition x12 := Add (Mul x8 x9) (Mul x11 (Var 18)).
Definition x13 := Sub (Var 4) (Var 7).
Definition x14 := Add (Mul x8 x13) (Mul x11 (Var 19)).
Definition x15 := Sub (Var 5) (Var 8).
Definition x16 := Add (Mul x8 x15) (Mul x11 (Var 20)).
Definition x17 := Div (Cst 1 0) (Root (Add (Add (Mul x12 x12) (Mul x14 x14)) (Mul x16 x16))).
Definition x18 := Mul (Mul (Cst 1 1) (Cst 1 (-53))) x7.
Definition x19 := Choose Less (Mul (Add (Var 21) (Mul (Cst 5 2) (Cst 1 (-53)))) (Root x7)) x8 x17 (Choose Less x18 x10
  x17 (Neg x17)).
Definition x20 := Div (Add (Add (Mul x12 x0) (Mul x14 x1)) (Mul x16 x2)) x3.
Definition x21 := Add (Abs x10) x18.
Definition x22 := Sub (Var 3) (Var 0).
Definition x23 := Sub (Var 4) (Var 1).
Definition x24 := Sub (Var 5) (Var 2).
Definition x25 := Mul (Add (Abs (Add (Add (Mul x22 x9) (Mul x23 x13)) (Mul x24 x15))) (Mul (Mul (Cst 3 1) (Cst 1 (-53)))
  x7)) (Root (Div (Mul (Cst 1 0) x3) (Add (Add (Mul x22 x22) (Mul x23 x23)) (Mul x24 x24)))).
Definition x26 := Mul (Mul (Mul (Mul (Cst 1 2) x21) x25) x17) x17.
Definition x27 := Mul (Mul (Mul (Cst 37 0) (Cst 1 (-53))) x7) x17.
Definition u_x := Mul x19 (Sub x12 (Mul x20 x0)).
Definition u_y := Mul x19 (Sub x14 (Mul x20 x1)).
Definition u_z := Mul x19 (Sub x16 (Mul x20 x2)).
Definition error := Mul (Add (Mul x26 (Var 21)) x27) (Add (Cst 1 0) (Mul (Cst 1 3) (Add (Mul (Add x26 (Mul (Mul (Cst 1
  1) (Choose Less x21 x25 x25 x21)) x17)) (Var 21)) x27))).
Definition x28 := Add (Add (Mul x22 x22) (Mul x23 x23)) (Mul x24 x24).
Definition x29 := Mul (Add (Var 21) (Mul (Cst 5 2) (Cst 1 (-53)))) (Root x7).
Definition x30 := Add (Mul (Add x26 (Mul (Mul (Cst 1 1) (Choose Less x21 x25 x25 x21)) x17)) (Var 21)) x27.
Definition is_known := If Less (Var 21) (Cst 1 0) (If LessEqual (Cst 8424983333484575 (-219)) x7 (If LessEqual x7 (Cst
  2407412430484045 115) (If LessEqual (Cst 8424983333484575 (-219)) x28 (If LessEqual x28 (Cst 2407412430484045 115) (If
  LessEqual (Cst 8424983333484575 (-219)) x3 (If LessEqual x3 (Cst 2407412430484045 115) (If Less x29 x8 (If Less (Cst 0
  0) x17 (If Less x30 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x18 x10 (If Less (Cst
  0 0) x17 (If Less x30 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x8 (Neg x29) (If
  Less (Cst 0 0) x17 (If Less x30 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x10 (Neg
  x18) (If Less (Cst 0 0) x17 (If Less x30 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer
  None))))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None).
End AcrossTriangle.

Module AcrossCorner.
Definition x0 := Sub (Var 6) (Var 0).
Definition x1 := Sub (Var 7) (Var 1).
Definition x2 := Sub (Var 8) (Var 2).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Sub (Var 6) (Var 3).
Definition x5 := Sub (Var 7) (Var 4).
Definition x6 := Sub (Var 8) (Var 5).
Definition x7 := Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6).
Definition x8 := Mul (Cst 1 1) (Add x3 x7).
Definition x9 := Root x8.
Definition x10 := Add (Add (Mul (Var 18) (Add x0 x4)) (Mul (Var 19) (Add x1 x5))) (Mul (Var 20) (Add x2 x6)).
Definition x11 := Sub (Var 3) (Var 9).
Definition x12 := Add (Add (Mul x0 x4) (Mul x1 x5)) (Mul x2 x6).
Definition x13 := Mul (Cst 1 1) x12.
Definition x14 := Add (Mul x10 x11) (Mul x13 (Var 18)).
Definition x15 := Sub (Var 4) (Var 10).
Definition x16 := Add (Mul x10 x15) (Mul x13 (Var 19)).
Definition x17 := Sub (Var 5) (Var 11).
Definition x18 := Add (Mul x10 x17) (Mul x13 (Var 20)).
Definition x19 := Div (Cst 1 0) (Root (Add (Add (Mul x14 x14) (Mul x16 x16)) (Mul x18 x18))).
Definition x20 := Mul (Mul (Cst 1 1) (Cst 1 (-53))) x8.
Definition x21 := Choose Less (Mul (Add (Var 21) (Mul (Cst 5 2) (Cst 1 (-53)))) x9) x10 x19 (Choose Less x20 x12 x19
  (Neg x19)).
Definition x22 := Sub (Var 9) (Var 0).
Definition x23 := Sub (Var 10) (Var 1).
Definition x24 := Sub (Var 11) (Var 2).
Definition x25 := Add (Add (Mul x22 x22) (Mul x23 x23)) (Mul x24 x24).
Definition x26 := Div (Add (Add (Mul x14 x22) (Mul x16 x23)) (Mul x18 x24)) x25.
Definition x27 := Add (Abs x12) x20.
Definition x28 := Sub (Var 3) (Var 0).
Definition x29 := Sub (Var 4) (Var 1).
Definition x30 := Sub (Var 5) (Var 2).
Definition x31 := Root (Add (Add (Mul x11 x11) (Mul x15 x15)) (Mul x17 x17)).
Definition x32 := Add x9 x31.
Definition x33 := Mul x32 x32.
Definition x34 := Sub (Mul x29 x17) (Mul x30 x15).
Definition x35 := Sub (Mul x30 x11) (Mul x28 x17).
Definition x36 := Sub (Mul x28 x15) (Mul x29 x11).
Definition x37 := Add (Add (Mul x28 x28) (Mul x29 x29)) (Mul x30 x30).
Definition x38 := Sub (Root (Add (Add (Mul x34 x34) (Mul x35 x35)) (Mul x36 x36))) (Mul (Mul (Cst 5 (-53)) (Root x37))
  x31).
Definition x39 := Sub (Mul x1 x6) (Mul x2 x5).
Definition x40 := Sub (Mul x2 x4) (Mul x0 x6).
Definition x41 := Sub (Mul x0 x5) (Mul x1 x4).
Definition x42 := Add (Root (Add (Add (Mul x39 x39) (Mul x40 x40)) (Mul x41 x41))) (Mul (Mul (Cst 5 (-53)) (Root x3))
  (Root x7)).
Definition x43 := Mul (Add (Abs (Add (Add (Mul x28 x11) (Mul x29 x15)) (Mul x30 x17))) (Mul (Mul (Cst 3 1) (Cst 1
  (-53))) x33)) (Root (Div (Mul (Choose Less (Cst 0 0) x38 (Div (Mul x42 x42) (Mul x38 x38)) (Infinite)) x25) x37)).
Definition x44 := Mul (Mul (Mul (Mul (Cst 1 2) x27) x43) x19) x19.
Definition x45 := Mul (Mul (Mul (Cst 37 0) (Cst 1 (-53))) x33) x19.
Definition u_x := Mul x21 (Sub x14 (Mul x26 x22)).
Definition u_y := Mul x21 (Sub x16 (Mul x26 x23)).
Definition u_z := Mul x21 (Sub x18 (Mul x26 x24)).
Definition error := Mul (Add (Mul x44 (Var 21)) x45) (Add (Cst 1 0) (Mul (Cst 1 3) (Add (Mul (Add x44 (Mul (Mul (Cst 1
  1) (Choose Less x27 x43 x43 x27)) x19)) (Var 21)) x45))).
Definition x46 := Mul (Add (Var 21) (Mul (Cst 5 2) (Cst 1 (-53)))) x9.
Definition x47 := Add (Mul (Add x44 (Mul (Mul (Cst 1 1) (Choose Less x27 x43 x43 x27)) x19)) (Var 21)) x45.
Definition is_known := If Less (Var 21) (Cst 1 0) (If LessEqual (Cst 8424983333484575 (-219)) x8 (If LessEqual x8 (Cst
  2407412430484045 115) (If LessEqual (Cst 8424983333484575 (-219)) x37 (If LessEqual x37 (Cst 2407412430484045 115) (If
  LessEqual (Cst 8424983333484575 (-219)) x25 (If LessEqual x25 (Cst 2407412430484045 115) (If Less x46 x10 (If Less
  (Cst 0 0) x19 (If Less x47 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x20 x12 (If
  Less (Cst 0 0) x19 (If Less x47 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x10 (Neg
  x46) (If Less (Cst 0 0) x19 (If Less x47 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less
  x12 (Neg x20) (If Less (Cst 0 0) x19 (If Less x47 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None))
  (Answer None))))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None).
End AcrossCorner.

Module AcrossPolygon.
Definition x0 := Sub (Var 6) (Var 0).
Definition x1 := Sub (Var 7) (Var 1).
Definition x2 := Sub (Var 8) (Var 2).
Definition x3 := Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2).
Definition x4 := Sub (Var 6) (Var 3).
Definition x5 := Sub (Var 7) (Var 4).
Definition x6 := Sub (Var 8) (Var 5).
Definition x7 := Add (Add (Mul x4 x4) (Mul x5 x5)) (Mul x6 x6).
Definition x8 := Mul (Cst 1 1) (Add x3 x7).
Definition x9 := Root x8.
Definition x10 := Add (Add (Mul (Var 18) (Add x0 x4)) (Mul (Var 19) (Add x1 x5))) (Mul (Var 20) (Add x2 x6)).
Definition x11 := Sub (Var 0) (Var 9).
Definition x12 := Sub (Var 3) (Var 12).
Definition x13 := Add (Add (Mul x0 x4) (Mul x1 x5)) (Mul x2 x6).
Definition x14 := Mul (Cst 1 1) x13.
Definition x15 := Add (Mul x10 (Add x11 x12)) (Mul x14 (Var 18)).
Definition x16 := Sub (Var 1) (Var 10).
Definition x17 := Sub (Var 4) (Var 13).
Definition x18 := Add (Mul x10 (Add x16 x17)) (Mul x14 (Var 19)).
Definition x19 := Sub (Var 2) (Var 11).
Definition x20 := Sub (Var 5) (Var 14).
Definition x21 := Add (Mul x10 (Add x19 x20)) (Mul x14 (Var 20)).
Definition x22 := Div (Cst 1 0) (Root (Add (Add (Mul x15 x15) (Mul x18 x18)) (Mul x21 x21))).
Definition x23 := Mul (Mul (Cst 1 1) (Cst 1 (-53))) x8.
Definition x24 := Choose Less (Mul (Add (Var 21) (Mul (Cst 5 2) (Cst 1 (-53)))) x9) x10 x22 (Choose Less x23 x13 x22
  (Neg x22)).
Definition x25 := Sub (Var 12) (Var 9).
Definition x26 := Sub (Var 13) (Var 10).
Definition x27 := Sub (Var 14) (Var 11).
Definition x28 := Add (Add (Mul x25 x25) (Mul x26 x26)) (Mul x27 x27).
Definition x29 := Div (Add (Add (Mul x15 x25) (Mul x18 x26)) (Mul x21 x27)) x28.
Definition x30 := Add (Abs x13) x23.
Definition x31 := Sub (Var 0) (Var 12).
Definition x32 := Sub (Var 1) (Var 13).
Definition x33 := Sub (Var 2) (Var 14).
Definition x34 := Root (Add (Add (Mul x11 x11) (Mul x16 x16)) (Mul x19 x19)).
Definition x35 := Add x9 (Add x34 (Root (Add (Add (Mul x12 x12) (Mul x17 x17)) (Mul x20 x20)))).
Definition x36 := Mul x35 x35.
Definition x37 := Sub (Mul x16 x33) (Mul x19 x32).
Definition x38 := Sub (Mul x19 x31) (Mul x11 x33).
Definition x39 := Sub (Mul x11 x32) (Mul x16 x31).
Definition x40 := Sub (Root (Add (Add (Mul x37 x37) (Mul x38 x38)) (Mul x39 x39))) (Mul (Mul (Cst 5 (-53)) x34) (Root
  (Add (Add (Mul x31 x31) (Mul x32 x32)) (Mul x33 x33)))).
Definition x41 := Sub (Mul x1 x6) (Mul x2 x5).
Definition x42 := Sub (Mul x2 x4) (Mul x0 x6).
Definition x43 := Sub (Mul x0 x5) (Mul x1 x4).
Definition x44 := Add (Root (Add (Add (Mul x41 x41) (Mul x42 x42)) (Mul x43 x43))) (Mul (Mul (Cst 5 (-53)) (Root x3))
  (Root x7)).
Definition x45 := Sub (Var 3) (Var 0).
Definition x46 := Sub (Var 4) (Var 1).
Definition x47 := Sub (Var 5) (Var 2).
Definition x48 := Mul (Add (Abs (Add (Add (Mul x11 x31) (Mul x16 x32)) (Mul x19 x33))) (Mul (Mul (Cst 3 1) (Cst 1
  (-53))) x36)) (Root (Div (Mul (Choose Less (Cst 0 0) x40 (Div (Mul x44 x44) (Mul x40 x40)) (Infinite)) x28) (Add (Add
  (Mul x45 x45) (Mul x46 x46)) (Mul x47 x47)))).
Definition x49 := Mul (Mul (Mul (Mul (Cst 1 2) x30) x48) x22) x22.
Definition x50 := Mul (Mul (Mul (Cst 37 0) (Cst 1 (-53))) x36) x22.
Definition u_x := Mul x24 (Sub x15 (Mul x29 x25)).
Definition u_y := Mul x24 (Sub x18 (Mul x29 x26)).
Definition u_z := Mul x24 (Sub x21 (Mul x29 x27)).
Definition error := Mul (Add (Mul x49 (Var 21)) x50) (Add (Cst 1 0) (Mul (Cst 1 3) (Add (Mul (Add x49 (Mul (Mul (Cst 1
  1) (Choose Less x30 x48 x48 x30)) x22)) (Var 21)) x50))).
Definition x51 := Add (Add (Mul x45 x45) (Mul x46 x46)) (Mul x47 x47).
Definition x52 := Mul (Add (Var 21) (Mul (Cst 5 2) (Cst 1 (-53)))) x9.
Definition x53 := Add (Mul (Add x49 (Mul (Mul (Cst 1 1) (Choose Less x30 x48 x48 x30)) x22)) (Var 21)) x50.
Definition is_known := If Less (Var 21) (Cst 1 0) (If LessEqual (Cst 8424983333484575 (-219)) x8 (If LessEqual x8 (Cst
  2407412430484045 115) (If LessEqual (Cst 8424983333484575 (-219)) x51 (If LessEqual x51 (Cst 2407412430484045 115) (If
  LessEqual (Cst 8424983333484575 (-219)) x28 (If LessEqual x28 (Cst 2407412430484045 115) (If Less x52 x10 (If Less
  (Cst 0 0) x22 (If Less x53 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x23 x13 (If
  Less (Cst 0 0) x22 (If Less x53 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less x10 (Neg
  x52) (If Less (Cst 0 0) x22 (If Less x53 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None)) (If Less
  x13 (Neg x23) (If Less (Cst 0 0) x22 (If Less x53 (Cst 1 (-4)) (Answer (Some Positive)) (Answer None)) (Answer None))
  (Answer None))))) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer
  None).
End AcrossPolygon.
