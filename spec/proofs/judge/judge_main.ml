(* The judge as a program. It reads rows, then records with their certificates, and prints a verdict for each record.
   What it calls, prepare and judge, is extracted from Judge.v; that it reads the numbers as they stand is not proved.
   The first line has the number of rows. A row has the mantissas and the exponents of x, y and z by turns.
   A record is a line of fields between semicolons, of numbers between blanks:
   index, or the two numbers of a kind; contact set; numerators and denominators of the center; those of the squared
   distance; weights; form. Of these the center and the squared distance may be empty. *)
open Judge_extracted

let words text = List.filter (fun word -> word <> "") (String.split_on_char ' ' text)
let numbers text = List.map Big_int_Z.big_int_of_string (words text)
let ratio numerator denominator = { numerator; denominator }

let row_of line =
  match numbers line with
  | [ a; b; c; d; e; f ] ->
    let dyadic mantissa exponent = { mantissa; exponent } in
    { row_x = dyadic a b; row_y = dyadic c d; row_z = dyadic e f }
  | _ -> failwith "a row has six numbers"

let kind_of text =
  match List.map int_of_string (words text) with
  | [ index ] -> Critical index
  | [ face; hull ] -> Regular (face, hull)
  | _ -> failwith "a kind has one number or two"

let center_of text =
  match numbers text with
  | [] -> None
  | [ a; b; c; d; e; f ] -> Some ((ratio a b, ratio c d), ratio e f)
  | _ -> failwith "a center has six numbers"

let squared_distance_of text =
  match numbers text with
  | [] -> None
  | [ a; b ] -> Some (ratio a b)
  | _ -> failwith "a squared distance has two numbers"

let form_of text =
  match numbers text with
  | [ zx; zy; zz ] -> { zx; zy; zz }
  | _ -> failwith "a form has three numbers"

let verdict_of points line =
  match String.split_on_char ';' line with
  | [ kind; contact; center; squared_distance; weights; form ] ->
    judge points
      { claimed_kind = kind_of kind;
        claimed_contact = numbers contact;
        claimed_center = center_of center;
        claimed_squared_distance = squared_distance_of squared_distance }
      { weights = numbers weights; form = form_of form }
  | _ -> failwith "a record has six fields"

let text_of = function
  | Proved -> "proved"
  | NoSuchRows -> "the contact set has no such ascending ids"
  | WeightsUnfit -> "no weights show that it is stationary"
  | WrongCenter -> "the center is another"
  | WrongSquaredDistance -> "the squared distance is another"
  | WrongKind -> "the kind is another"
  | WrongContactSet -> "the contact set is another"

let () =
  let count = int_of_string (String.trim (input_line stdin)) in
  let rec read done_ left = if left = 0 then List.rev done_ else read (row_of (input_line stdin) :: done_) (left - 1) in
  let points = prepare (read [] count) in
  try
    while true do
      print_endline (text_of (verdict_of points (input_line stdin)))
    done
  with End_of_file -> ()
