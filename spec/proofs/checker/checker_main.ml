(* Runs the extracted checker of certificates: checker POINTS CERTIFICATE, or checker --batch with a pair of names a
   line on standard input. It prints what is proved, as flowcert-proof does. In a batch it prints a line for each pair:
   the exit status, what is told, and the kind and the contact set of each stationary point.
   Exit status: 0, proved; 1, rejected; 2, cannot be decoded.

   This file is not proved. It reads points, from text to doubles and from doubles to integers on one grid, and the
   header of a certificate, and it counts and prints. All else is in the other files of this folder. *)
module Integer = Z  (* zarith's own; the extracted code has another Z *)
open Checker_extracted

exception Cannot_decode of string

let fail why = raise (Cannot_decode why)

let bytes_of_file path =
  let file = try open_in_bin path with Sys_error why -> fail why in
  let bytes = really_input_string file (in_channel_length file) in
  close_in file;
  bytes

(* ---- Points ---- *)

let is_of set c = String.contains set c

(* The end of the characters of a set from a place on. *)
let rec span set text at = if at < String.length text && is_of set text.[at] then span set text (at + 1) else at

let rows_of_text text =
  if text = "" then fail "no points";
  let size = String.length text in
  let decimal at =
    let stop = span "0123456789.e+-" text at in
    let word = String.sub text at (stop - at) in
    if word = "" || word.[0] = '+' then fail "not a decimal";
    match float_of_string_opt word with Some x -> (x, stop) | None -> fail "not a decimal"
  in
  let blanks at =
    let stop = span " \t" text at in
    if stop = at then fail "no blank between decimals" else stop
  in
  let rec rows at found =
    if at = size then List.rev found
    else
      let x, at = decimal at in
      let y, at = decimal (blanks at) in
      let z, at = decimal (blanks at) in
      let at = if at + 1 < size && text.[at] = '\r' && text.[at + 1] = '\n' then at + 1 else at in
      if at < size && text.[at] <> '\n' then fail "not three decimals";
      rows (min size (at + 1)) ([ x; y; z ] :: found)
  in
  rows 0 []

let rows_of_doubles bytes =
  if String.length bytes mod 24 <> 0 then fail "not 24 bytes a row";
  let double at = Int64.float_of_bits (String.get_int64_le bytes at) in
  List.init (String.length bytes / 24) (fun k -> List.init 3 (fun i -> double ((24 * k) + (8 * i))))

(* A double as an integer times a power of two. *)
let mantissa_and_exponent x =
  if not (Float.is_finite x) then fail "not finite";
  let fraction, exponent = Float.frexp x in
  (Integer.of_float (Float.ldexp fraction 53), exponent - 53)

let on_grid rows =
  let parts = List.map (List.map mantissa_and_exponent) rows in
  let lower low (m, e) = if Integer.equal m Integer.zero then low else min low e in
  let low = List.fold_left (List.fold_left lower) 2000 parts in
  let integer (m, e) = if Integer.equal m Integer.zero then Integer.zero else Integer.shift_left m (e - low) in
  let point = function [ x; y; z ] -> { zx = integer x; zy = integer y; zz = integer z } | _ -> assert false in
  List.map point parts

let points_of path =
  let bytes = bytes_of_file path in
  if Filename.check_suffix path ".xyz" then on_grid (rows_of_text bytes)
  else if Filename.check_suffix path ".f64" then on_grid (rows_of_doubles bytes)
  else fail "neither .xyz nor .f64"

(* ---- Certificates ---- *)

(* The dimension plus one, the number of cells, and the bytes of a certificate's body (FC-FILE-48). *)
let header bytes row_count =
  let at = ref 0 in
  let take text =
    let size = String.length text in
    let is_there = !at + size <= String.length bytes && String.sub bytes !at size = text in
    if is_there then at := !at + size;
    is_there
  in
  let need text = if not (take text) then fail "header" in
  need "flowcert-certificate 1\npoints ";
  need (string_of_int row_count ^ "\n");
  if take "sha256 " then begin
    let stop = span "0123456789abcdef" bytes !at in
    if stop <> !at + 64 then fail "hash";
    at := stop;
    need "\n"
  end;
  need "dimension ";
  let dimension = match List.find_opt (fun d -> take (string_of_int d ^ "\ncells ")) [ -1; 0; 1; 2; 3 ] with
    | Some d -> d
    | None -> fail "dimension"
  in
  let stop = span "0123456789" bytes !at in
  let digits = String.sub bytes !at (stop - !at) in
  at := stop;
  need "\n\n";
  let count = match int_of_string_opt digits with
    | Some count when string_of_int count = digits -> count
    | _ -> fail "number of cells"
  in
  let size = String.length bytes - !at in
  if (count = 0) <> (dimension < 1) || count > size then fail "number of cells";
  (dimension + 1, count, List.init size (fun k -> Integer.of_int (Char.code bytes.[!at + k])))

let name_of = function
  | T0 -> "T0" | T1 -> "T1" | T2 -> "T2" | T3 -> "T3" | T4 -> "T4" | T5 -> "T5" | T6 -> "T6" | T7 -> "T7" | T8 -> "T8"

let told rows (cells, points) =
  let count kind = List.length (List.filter (fun p -> p.kind_of = kind) points) in
  Printf.sprintf
    "proved: these %d cells are a Delaunay triangulation of %d points (%d different ones)\n\
     proved: all %d stationary points: critical %d %d %d %d, regular 1-2: %d, 1-3: %d, 2-3: %d"
    (List.length cells) (List.length rows) (count Index0) (List.length points) (count Index0) (count Index1)
    (count Index2) (count Index3) (count Regular12) (count Regular13) (count Regular23)

(* The kinds and contact sets, in the order of a list (FC-OUT-02). *)
let listed points =
  let number = function
    | Index0 -> 0 | Index1 -> 1 | Index2 -> 2 | Index3 -> 3 | Regular12 -> 4 | Regular13 -> 5 | Regular23 -> 6
  in
  let line (kind, contact) = String.concat " " (List.map string_of_int (kind :: contact)) in
  List.map line (List.sort compare (List.map (fun p -> (number p.kind_of, p.contact_of)) points))

(* An exit status, what is told, and for what is proved the list. *)
let verdict points_path certificate_path =
  try
    let rows = points_of points_path in
    let places, count, body = header (bytes_of_file certificate_path) (List.length rows) in
    match check_certificate rows places count body with
    | Undecodable -> (2, "cannot be decoded: its body", [])
    | Rejected condition -> (1, "certificate rejected: " ^ name_of condition, [])
    | Holds proved -> (0, told rows proved, listed (snd proved))
  with Cannot_decode why -> (2, "cannot be decoded: " ^ why, [])

let rec batch () =
  match String.split_on_char ' ' (input_line stdin) with
  | [ points; certificate ] ->
    let status, text, list = verdict points certificate in
    let text = String.concat "; " (String.split_on_char '\n' text) in
    print_endline (String.concat "; " (Printf.sprintf "%d %s" status text :: list));
    batch ()
  | _ -> failwith "two names a line"
  | exception End_of_file -> ()

let () =
  match Array.to_list Sys.argv with
  | [ _; "--batch" ] -> batch ()
  | [ _; points; certificate ] ->
    let status, text, _ = verdict points certificate in
    (if status = 2 then prerr_endline else print_endline) text;
    exit status
  | _ ->
    prerr_endline "usage: checker POINTS CERTIFICATE | checker --batch";
    exit 2
