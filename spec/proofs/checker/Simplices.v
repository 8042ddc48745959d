(* Simplices of the certificate's checker, over the integers: volumes, smallest spheres, faces.
   A sample is known by the number of its row, and the rows are points of one grid of integers.
   A simplex is a list of samples. *)
From Coq Require Import ZArith List Bool.
From Flowcert Require Import judge.Judge.
Import ListNotations.
Open Scope Z_scope.

Definition simplex := list nat.
Definition place (rows : list zvec) (i : nat) : zvec := nth i rows (ZV 0 0 0).
Definition places (rows : list zvec) (s : simplex) : list zvec := map (place rows) s.

(* The vectors from the first point to the others. *)
Definition edges (s : list zvec) : list zvec :=
  match s with [] => [] | o :: s' => map (fun p => zsub p o) s' end.
Definition seen_from (x : zvec) (s : list zvec) : list zvec := map (fun p => zsub p x) s.

(* The volume of d vectors in dimension d, up to one positive factor. In dimension 1 and 2, n is the edge of the first
   cell, or its normal. *)
Definition volume (n : zvec) (v : list zvec) : Z :=
  match v with
  | [a] => zdot a n
  | [a; b] => zdot (zcross a b) n
  | [a; b; c] => zdet a b c
  | _ => 0
  end.

(* The centre of the smallest sphere through one to four points: a vector from the first one, times 2k; and k. *)
Definition centre_of_edges (v : list zvec) : zvec * Z :=
  match v with
  | [a] => (a, 1)
  | [a; b] =>
    let c := zcross a b in
    (zadd (zscale (zdot a a) (zcross b c)) (zscale (zdot b b) (zcross c a)), zdot c c)
  | [a; b; c] =>
    (zadd (zscale (zdot a a) (zcross b c))
          (zadd (zscale (zdot b b) (zcross c a)) (zscale (zdot c c) (zcross a b))), zdet a b c)
  | _ => (ZV 0 0 0, 1)
  end.
Definition origin (s : list zvec) : zvec := hd (ZV 0 0 0) s.

(* k^2 times the power of p to that sphere: positive outside of it, 0 on it, negative inside. *)
Definition outside (s : list zvec) (p : zvec) : Z :=
  let '(toward, k) := centre_of_edges (edges s) in
  let v := zsub p (origin s) in
  k * (k * zdot v v - zdot toward v).

(* The barycentric coordinates of the centre, times 2 k^2. *)
Definition centre_weights (s : list zvec) : list Z :=
  let '(toward, k) := centre_of_edges (edges s) in
  match edges s with
  | [] => [2]
  | [a] => [1; 1]
  | [a; b] =>
    let c := zcross a b in
    let u := zdot toward (zcross b c) in
    let v := zdot toward (zcross c a) in
    [2 * k * k - u - v; u; v]
  | [a; b; c] =>
    let u := zdot toward (zcross b c) in
    let v := zdot toward (zcross c a) in
    let w := zdot toward (zcross a b) in
    [2 * k * k - u - v - w; u; v; w]
  | _ => []
  end.
Definition centre_is_inside (s : list zvec) : bool := forallb (Z.ltb 0) (centre_weights s).

(* ---- Faces ---- *)

Definition same_samples (s t : simplex) : bool :=
  (fix same s t := match s, t with
   | [], [] => true
   | a :: s', b :: t' => Nat.eqb a b && same s' t'
   | _, _ => false
   end) s t.
Definition has_sample (s : simplex) (p : nat) : bool := existsb (Nat.eqb p) s.
Definition is_face (s t : simplex) : bool := forallb (has_sample t) s.
Definition without (i : nat) (s : simplex) : simplex := firstn i s ++ skipn (S i) s.

Fixpoint insert (a : nat) (s : simplex) : simplex :=
  match s with
  | [] => [a]
  | b :: s' => if Nat.leb a b then a :: s else b :: insert a s'
  end.
Definition sorted (s : simplex) : simplex := fold_right insert [] s.
(* Whether it takes an odd permutation to sort the samples. *)
Fixpoint is_odd (s : simplex) : bool :=
  match s with
  | [] => false
  | a :: s' => xorb (Nat.odd (length (filter (fun b => Nat.ltb b a) s'))) (is_odd s')
  end.

(* The face without vertex i: its samples in ascending order, and the orientation that is induced on it. *)
Definition face_of (s : simplex) (turn : bool) (i : nat) : simplex * bool :=
  let rest := without i s in
  (sorted rest, xorb turn (xorb (Nat.odd i) (is_odd rest))).
