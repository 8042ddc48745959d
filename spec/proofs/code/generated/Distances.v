(* Printed by flowcert-proof-terms; not to be edited. *)
From Coq Require Import ZArith.
From Flowcert Require Import code.Expression.

Module Distances.
Definition x0 := Sub (Var 3) (Var 0).
Definition x1 := Sub (Var 4) (Var 1).
Definition x2 := Sub (Var 5) (Var 2).
Definition x3 := Add (Add (Mul (Var 0) (Cst 2251799813685251 (-51))) (Mul (Cst 1 (-51)) (Var 1))) (Cst 4606887725612233
  (-547)).
Definition distance := Root (Add (Add (Mul x0 x0) (Mul x1 x1)) (Mul x2 x2)).
Definition reach := Choose Less (Cst 5503284107318959 446) x3 (Infinite) x3.
End Distances.
