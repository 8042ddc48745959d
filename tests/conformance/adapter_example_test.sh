#!/usr/bin/env bash
# The adapter of src/certify/README.md, "Add your format", works when it is copied and put in as the text says: it
# builds, reads what the text says that the program prints, and refuses anything else with file and line.
# CITES: FC-CLAIM-01
#
# usage: adapter_example_test.sh BUILD_DIR COMPILER LIBRARY      (a build of this tree; libflowcert.a)
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
build=$(realpath "$1")
compiler=$2
library=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
  echo "FAIL: $*"
  exit 1
}

mkdir -p "$scratch/certify/claims"
awk '
  inside && /^```/ { exit }
  inside { print }
  marked && /^```/ { inside = 1; marked = 0 }
  $0 == "<!-- example: adapter -->" { marked = 1 }' "$root/src/certify/README.md" >"$scratch/certify/claims/read_my_claim.cpp"
[ -s "$scratch/certify/claims/read_my_claim.cpp" ] || fail "src/certify/README.md has no adapter"
lines=$(wc -l <"$scratch/certify/claims/read_my_claim.cpp")
[ "$lines" -le 50 ] || fail "the adapter has $lines lines: it should take 50"

# The two other edits that the README names.
sed 's/^extern const ClaimFormat kCsvClaims;/&\nextern const ClaimFormat kMyClaims;/' \
  "$root/src/certify/claims/claim_formats.h" >"$scratch/certify/claims/claim_formats.h"
sed 's/kFormats = {&/kFormats = {\&kMyClaims, \&/' "$root/src/certify/claims/read_claim.cpp" >"$scratch/certify/claims/read_claim.cpp"
for file in claim_formats.h read_claim.cpp; do
  grep -q kMyClaims "$scratch/certify/claims/$file" || fail "$file is no longer as the README says"
done

cat >"$scratch/main.cpp" <<'CPP'
#include <iostream>
#include "flowcert/claim.h"
int main(int, char** argv) {
  try {
    const flowcert::Claim claim = flowcert::read_claim(argv[1]);
    std::cout << claim.format;
    for (const auto& point : claim.points) {
      std::cout << " | " << point.index << " at " << flowcert::to_text((*point.center)[1].value) << " of";
      for (const auto id : point.contact) std::cout << ' ' << id;
    }
    std::cout << '\n';
  } catch (const flowcert::InvalidInput& error) {
    std::cout << error.what() << '\n';
  }
}
CPP
flags=() public_headers=("$root"/src/*/include)
case "$(sed -n 's/^FLOWCERT_SANITIZE:[A-Z]*=//p' "$build/CMakeCache.txt")" in ON) flags+=(-fsanitize=address,undefined) ;; esac
case "$(sed -n 's/^FLOWCERT_COVERAGE:[A-Z]*=//p' "$build/CMakeCache.txt")" in ON) flags+=(--coverage) ;; esac
"$compiler" -std=c++20 -Wall -Wextra -Wconversion -Werror "${flags[@]}" -I "$scratch" -I "$root/src" \
  "${public_headers[@]/#/-I}" \
  "$scratch/main.cpp" "$scratch/certify/claims/read_claim.cpp" "$scratch/certify/claims/read_my_claim.cpp" "$library" \
  -lgmp -lmpfr -lz -lexpat -lcrypto -lfmt -pthread -o "$scratch/reader" || fail "the adapter does not build"

expect() {
  local result
  result=$("$scratch/reader" "$1")
  [ "$result" = "$2" ] || fail "$result"$'\n'"  and not $2"
}
printf '# my flow 1.0\nminimum 0 0 0 : 3\nsaddle2 0.5 0.25 1 : 3 17 20\n' >"$scratch/claim"
expect "$scratch/claim" "mine | 0 at 0 of 3 | 2 at 1/4 of 3 17 20"
gzip -c "$scratch/claim" >"$scratch/claim.gz"
expect "$scratch/claim.gz" "mine | 0 at 0 of 3 | 2 at 1/4 of 3 17 20"
printf '# my flow 1.0\nsaddle3 0.5 0.25 1 : 3\n' >"$scratch/wrong"
expect "$scratch/wrong" "$scratch/wrong:2: not a kind of critical point: 'saddle3'"
printf '0,0,0,0,0,3\n' >"$scratch/csv"
expect "$scratch/csv" "csv | 0 at 0 of 3"
echo "ok: an adapter of $lines lines"
