(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.
From Flowcert Require Import code.Expression.

Module Cell.
Definition x0 := Add (Add (Mul (Var 0) (Var 3)) (Mul (Var 1) (Var 4))) (Mul (Var 2) (Var 5)).
Definition x1 := Add (Add (Mul (Var 6) (Var 0)) (Mul (Var 7) (Var 1))) (Mul (Var 8) (Var 2)).
Definition x2 := Add (Add (Mul (Var 3) (Var 6)) (Mul (Var 4) (Var 7))) (Mul (Var 5) (Var 8)).
Definition x3 := Add (Add (Mul (Var 0) (Var 0)) (Mul (Var 1) (Var 1))) (Mul (Var 2) (Var 2)).
Definition x4 := Sub x3 x1.
Definition x5 := Add (Add (Mul (Var 3) (Var 3)) (Mul (Var 4) (Var 4))) (Mul (Var 5) (Var 5)).
Definition x6 := Sub x5 x2.
Definition x7 := Add (Add (Mul (Var 6) (Var 6)) (Mul (Var 7) (Var 7))) (Mul (Var 8) (Var 8)).
Definition x8 := Sub x7 x2.
Definition x9 := Sub (Mul (Var 4) (Var 8)) (Mul (Var 5) (Var 7)).
Definition x10 := Sub (Mul (Var 5) (Var 6)) (Mul (Var 3) (Var 8)).
Definition x11 := Sub (Mul (Var 3) (Var 7)) (Mul (Var 4) (Var 6)).
Definition x12 := Add (Add (Mul (Var 0) x9) (Mul (Var 1) x10)) (Mul (Var 2) x11).
Definition x13 := Sub (Mul (Var 7) (Var 2)) (Mul (Var 8) (Var 1)).
Definition x14 := Sub (Mul (Var 1) (Var 5)) (Mul (Var 2) (Var 4)).
Definition x15 := Add (Add (Mul x3 x9) (Mul x5 x13)) (Mul x7 x14).
Definition x16 := Sub (Mul (Var 8) (Var 0)) (Mul (Var 6) (Var 2)).
Definition x17 := Sub (Mul (Var 2) (Var 3)) (Mul (Var 0) (Var 5)).
Definition x18 := Add (Add (Mul x3 x10) (Mul x5 x16)) (Mul x7 x17).
Definition x19 := Sub (Mul (Var 6) (Var 1)) (Mul (Var 7) (Var 0)).
Definition x20 := Sub (Mul (Var 0) (Var 4)) (Mul (Var 1) (Var 3)).
Definition x21 := Add (Add (Mul x3 x11) (Mul x5 x19)) (Mul x7 x20).
Definition x22 := Add (Add (Mul x9 x15) (Mul x10 x18)) (Mul x11 x21).
Definition x23 := Add (Add (Mul x13 x15) (Mul x16 x18)) (Mul x19 x21).
Definition x24 := Add (Add (Mul x14 x15) (Mul x17 x18)) (Mul x20 x21).
Definition x25 := Root x7.
Definition x26 := Root x5.
Definition x27 := Root x3.
Definition x28 := Choose Less x26 x27 x26 x27.
Definition x29 := Choose Less x27 x26 x26 x27.
Definition x30 := Choose Less x29 x25 x25 x29.
Definition x31 := Choose LessEqual (Cst 6277101735386681 (-192)) (Choose Less x25 x28 x25 x28) (Choose LessEqual x30
  (Cst 6462348535570529 87) (Cst 1 (-53)) (Infinite)) (Infinite).
Definition x32 := Mul x27 x26.
Definition x33 := Mul (Mul x32 x25) (Add (Add x27 x26) x25).
Definition x34 := Mul x26 x25.
Definition x35 := Mul x25 x27.
Definition x36 := Mul (Mul (Cst 5 2) x31) x33.
Definition angle_0 := x0.
Definition angle_1 := x1.
Definition angle_2 := x2.
Definition angle_3 := Sub x3 x0.
Definition angle_4 := x4.
Definition angle_5 := Add (Sub x2 x0) x4.
Definition angle_6 := Sub x5 x0.
Definition angle_7 := x6.
Definition angle_8 := Add (Sub x1 x0) x6.
Definition angle_9 := Sub x7 x1.
Definition angle_10 := x8.
Definition angle_11 := Add (Sub x0 x1) x8.
Definition side_0 := Sub (Sub (Sub (Mul (Mul (Cst 1 1) x12) x12) x22) x23) x24.
Definition side_1 := x22.
Definition side_2 := x23.
Definition side_3 := x24.
Definition angle_error := Mul (Mul (Mul (Cst 29 0) x31) x30) x30.
Definition side_error_0 := Mul (Mul (Mul (Cst 7 2) x31) x33) (Add (Add x32 x34) x35).
Definition side_error_1 := Mul x36 x34.
Definition side_error_2 := Mul x36 x35.
Definition side_error_3 := Mul x36 x32.
Definition certain_sign := If Less (Var 1) (Abs (Var 0)) (If Less (Var 0) (Cst 0 0) (Answer (Some Negative)) (Answer
  (Some Positive))) (Answer None).
Definition is_cell_exact := If LessEqual (Cst 6277101735386681 (-192)) (Choose Less x25 x28 x25 x28) (If LessEqual x30
  (Cst 6462348535570529 87) (If LessEqual x30 (Var 15) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer
  None).
Definition x37 := Add (Add (Mul (Var 9) (Var 9)) (Mul (Var 10) (Var 10))) (Mul (Var 11) (Var 11)).
Definition x38 := Root x37.
Definition is_beyond_sphere := If LessEqual (Cst 6277101735386681 (-192)) (Choose Less x25 x28 x25 x28) (If LessEqual
  x30 (Cst 6462348535570529 87) (If LessEqual (Cst 6277101735386681 (-192)) x38 (If LessEqual x38 (Cst 6462348535570529
  87) (If Less (Mul (Mul (Mul (Cst 9 (-52)) (Mul x32 x25)) x38) (Add (Add (Add x27 x26) x25) x38)) (Abs (Sub (Mul x37
  x12) (Add (Add (Mul x15 (Var 9)) (Mul x18 (Var 10))) (Mul x21 (Var 11))))) (Answer (Some Positive)) (Answer None))
  (Answer None)) (Answer None)) (Answer None)) (Answer None).
Definition is_exact := If LessEqual (Cst 6277101735386681 (-192)) (Choose Less x25 x28 x25 x28) (If LessEqual x30 (Cst
  6462348535570529 87) (If LessEqual (Cst 6277101735386681 (-192)) x38 (If LessEqual x38 (Cst 6462348535570529 87) (If
  LessEqual x30 (Var 15) (If LessEqual x38 (Var 15) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer
  None)) (Answer None)) (Answer None)) (Answer None).
Definition is_on_sphere := If Equal (Sub (Mul x37 x12) (Add (Add (Mul x15 (Var 9)) (Mul x18 (Var 10))) (Mul x21 (Var
  11)))) (Cst 0 0) (Answer (Some Positive)) (Answer None).
End Cell.

Module CellIntegers.
Definition x0 := Add (Add (Mul (Var 0) (Var 3)) (Mul (Var 1) (Var 4))) (Mul (Var 2) (Var 5)).
Definition x1 := Add (Add (Mul (Var 6) (Var 0)) (Mul (Var 7) (Var 1))) (Mul (Var 8) (Var 2)).
Definition x2 := Add (Add (Mul (Var 3) (Var 6)) (Mul (Var 4) (Var 7))) (Mul (Var 5) (Var 8)).
Definition x3 := Add (Add (Mul (Var 0) (Var 0)) (Mul (Var 1) (Var 1))) (Mul (Var 2) (Var 2)).
Definition x4 := Sub x3 x1.
Definition x5 := Add (Add (Mul (Var 3) (Var 3)) (Mul (Var 4) (Var 4))) (Mul (Var 5) (Var 5)).
Definition x6 := Sub x5 x2.
Definition x7 := Add (Add (Mul (Var 6) (Var 6)) (Mul (Var 7) (Var 7))) (Mul (Var 8) (Var 8)).
Definition x8 := Sub x7 x2.
Definition x9 := Wide (Sub (Mul (Var 4) (Var 8)) (Mul (Var 5) (Var 7))).
Definition x10 := Wide (Sub (Mul (Var 5) (Var 6)) (Mul (Var 3) (Var 8))).
Definition x11 := Wide (Sub (Mul (Var 3) (Var 7)) (Mul (Var 4) (Var 6))).
Definition x12 := Add (Add (Mul (Wide (Var 0)) x9) (Mul (Wide (Var 1)) x10)) (Mul (Wide (Var 2)) x11).
Definition x13 := Wide x3.
Definition x14 := Wide x5.
Definition x15 := Wide (Sub (Mul (Var 7) (Var 2)) (Mul (Var 8) (Var 1))).
Definition x16 := Wide x7.
Definition x17 := Wide (Sub (Mul (Var 1) (Var 5)) (Mul (Var 2) (Var 4))).
Definition x18 := Add (Add (Mul x13 x9) (Mul x14 x15)) (Mul x16 x17).
Definition x19 := Wide (Sub (Mul (Var 8) (Var 0)) (Mul (Var 6) (Var 2))).
Definition x20 := Wide (Sub (Mul (Var 2) (Var 3)) (Mul (Var 0) (Var 5))).
Definition x21 := Add (Add (Mul x13 x10) (Mul x14 x19)) (Mul x16 x20).
Definition x22 := Wide (Sub (Mul (Var 6) (Var 1)) (Mul (Var 7) (Var 0))).
Definition x23 := Wide (Sub (Mul (Var 0) (Var 4)) (Mul (Var 1) (Var 3))).
Definition x24 := Add (Add (Mul x13 x11) (Mul x14 x22)) (Mul x16 x23).
Definition x25 := Add (Add (Mul x9 x18) (Mul x10 x21)) (Mul x11 x24).
Definition x26 := Add (Add (Mul x15 x18) (Mul x19 x21)) (Mul x22 x24).
Definition x27 := Add (Add (Mul x17 x18) (Mul x20 x21)) (Mul x23 x24).
Definition angle_0 := x0.
Definition angle_1 := x1.
Definition angle_2 := x2.
Definition angle_3 := Sub x3 x0.
Definition angle_4 := x4.
Definition angle_5 := Add (Sub x2 x0) x4.
Definition angle_6 := Sub x5 x0.
Definition angle_7 := x6.
Definition angle_8 := Add (Sub x1 x0) x6.
Definition angle_9 := Sub x7 x1.
Definition angle_10 := x8.
Definition angle_11 := Add (Sub x0 x1) x8.
Definition side_0 := Sub (Sub (Sub (Mul (Mul (Cst 1 1) x12) x12) x25) x26) x27.
Definition side_1 := x25.
Definition side_2 := x26.
Definition side_3 := x27.
End CellIntegers.
