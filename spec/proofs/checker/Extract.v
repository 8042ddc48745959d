(* The checker of certificates as OCaml: writes checker/checker_extracted.ml, which checker_main.ml calls.
   Integers become those of zarith. nat becomes int, which stands for places of rows and cells, and for dimensions.
   No other function is replaced than those of Coq's own ExtrOcamlZBigInt and ExtrOcamlNatInt. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt.
From Flowcert Require Import checker.StationaryList.
Extraction "checker/checker_extracted.ml" check_certificate.
