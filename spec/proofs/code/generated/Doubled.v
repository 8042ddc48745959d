(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.
From Flowcert Require Import code.Expression.

Module Doubled.
Definition x0 := Add (Var 0) (Var 1).
Definition x1 := Sub x0 (Var 0).
Definition x2 := Mul (Var 0) (Var 1).
Definition x3 := Mul (Cst 134217729 0) (Var 0).
Definition x4 := Sub x3 (Sub x3 (Var 0)).
Definition x5 := Mul (Cst 134217729 0) (Var 1).
Definition x6 := Sub x5 (Sub x5 (Var 1)).
Definition x7 := Sub (Var 1) x6.
Definition x8 := Sub (Var 0) x4.
Definition x9 := Add (Var 0) (Var 2).
Definition x10 := Sub x9 (Var 0).
Definition x11 := Add (Var 1) (Var 3).
Definition x12 := Add (Add (Sub (Var 0) (Sub x9 x10)) (Sub (Var 2) x10)) x11.
Definition x13 := Add x9 x12.
Definition x14 := Sub x11 (Var 1).
Definition x15 := Add (Add (Sub (Var 1) (Sub x11 x14)) (Sub (Var 3) x14)) (Sub x12 (Sub x13 x9)).
Definition x16 := Add x13 x15.
Definition x17 := Neg (Var 2).
Definition x18 := Add (Var 0) x17.
Definition x19 := Sub x18 (Var 0).
Definition x20 := Neg (Var 3).
Definition x21 := Add (Var 1) x20.
Definition x22 := Add (Add (Sub (Var 0) (Sub x18 x19)) (Sub x17 x19)) x21.
Definition x23 := Add x18 x22.
Definition x24 := Sub x21 (Var 1).
Definition x25 := Add (Add (Sub (Var 1) (Sub x21 x24)) (Sub x20 x24)) (Sub x22 (Sub x23 x18)).
Definition x26 := Add x23 x25.
Definition x27 := Mul (Var 0) (Var 2).
Definition x28 := Mul (Cst 134217729 0) (Var 2).
Definition x29 := Sub x28 (Sub x28 (Var 2)).
Definition x30 := Sub (Var 2) x29.
Definition x31 := Add (Add (Add (Add (Sub (Mul x4 x29) x27) (Mul x4 x30)) (Mul x8 x29)) (Mul x8 x30)) (Add (Mul (Var 0)
  (Var 3)) (Mul (Var 1) (Var 2))).
Definition x32 := Add x27 x31.
Definition x33 := Div (Var 0) (Var 2).
Definition x34 := Mul (Var 2) x33.
Definition x35 := Mul (Cst 134217729 0) x33.
Definition x36 := Sub x35 (Sub x35 x33).
Definition x37 := Sub x33 x36.
Definition x38 := Add (Add (Add (Add (Sub (Mul x29 x36) x34) (Mul x29 x37)) (Mul x30 x36)) (Mul x30 x37)) (Mul (Var 3)
  x33).
Definition x39 := Add x34 x38.
Definition x40 := Div (Add (Sub (Var 0) x39) (Sub (Var 1) (Sub x38 (Sub x39 x34)))) (Var 2).
Definition x41 := Add x33 x40.
Definition sum_high := x0.
Definition sum_low := Add (Sub (Var 0) (Sub x0 x1)) (Sub (Var 1) x1).
Definition product_high := x2.
Definition product_low := Add (Add (Add (Sub (Mul x4 x6) x2) (Mul x4 x7)) (Mul x8 x6)) (Mul x8 x7).
Definition plus_high := x16.
Definition plus_low := Sub x15 (Sub x16 x13).
Definition minus_high := x26.
Definition minus_low := Sub x25 (Sub x26 x23).
Definition times_high := x32.
Definition times_low := Sub x31 (Sub x32 x27).
Definition quotient_high := x41.
Definition quotient_low := Sub x40 (Sub x41 x33).
Definition x42 := Root (Var 0).
Definition x43 := Mul x42 x42.
Definition x44 := Mul (Cst 134217729 0) x42.
Definition x45 := Sub x44 (Sub x44 x42).
Definition x46 := Sub x42 x45.
Definition root_high := If Less (Cst 0 0) (Var 0) (Answer (Add x42 (Div (Add (Sub (Sub (Var 0) x43) (Add (Add (Add (Sub
  (Mul x45 x45) x43) (Mul x45 x46)) (Mul x46 x45)) (Mul x46 x46))) (Var 1)) (Mul (Cst 1 1) x42)))) (Answer x42).
Definition x47 := Div (Add (Sub (Sub (Var 0) x43) (Add (Add (Add (Sub (Mul x45 x45) x43) (Mul x45 x46)) (Mul x46 x45))
  (Mul x46 x46))) (Var 1)) (Mul (Cst 1 1) x42).
Definition root_low := If Less (Cst 0 0) (Var 0) (Answer (Sub x47 (Sub (Add x42 x47) x42))) (Answer (Cst 0 0)).
Definition absolute_high := If Less (Var 0) (Cst 0 0) (Answer (Neg (Var 0))) (Answer (Var 0)).
Definition absolute_low := If Less (Var 0) (Cst 0 0) (Answer (Neg (Var 1))) (Answer (Var 1)).
Definition is_less := If Less (Var 0) (Var 2) (Answer (Some Positive)) (If Equal (Var 0) (Var 2) (If Less (Var 1) (Var
  3) (Answer (Some Positive)) (Answer None)) (Answer None)).
End Doubled.
