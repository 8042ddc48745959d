From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt.
From Flowcert Require Import checker.StationaryList.
Extraction "checker/checker_extracted.ml" check_certificate.
