#!/usr/bin/env bash
# No type, and no inline function, is defined twice: all objects of a build at -O0 agree on the size of each weak
# symbol of ours.
#
# usage: one_definition_test.sh BUILD_DIR      (a build with -O0: inlining hides what differs)
#        one_definition_test.sh --self-test    (two types of one name are found; needs a compiler)
#
# The linker keeps one of the functions of a name. Where two types share it, some code calls the other's. ./dev
# same-types also asks the compiler, by -Wodr at link time; this test sees what the linker sees.
set -euo pipefail

# disagreements FOLDER: symbols of flowcert or of the oracle that have several sizes, each with its sizes and objects.
disagreements() {
  find "$1" -name '*.o' -print0 | xargs -0 readelf -sW | awk '
    /^File: / { file = $2 }
    $5 == "WEAK" && $7 != "UND" && $8 ~ /8flowcert|6oracle/ {
      symbols[$8] = 1
      if (!(($8, $3) in seen)) { seen[$8, $3] = 1; sizes[$8] = sizes[$8] "\n    " $3 " bytes in " file; ++count[$8] }
    }
    END {
      for (name in symbols) ++all
      for (name in count) if (count[name] > 1) print name sizes[name]
      print "symbols: " all + 0 > "/dev/stderr"
    }' | c++filt
}

if [ "${1:-}" = --self-test ]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  for size in 2 3; do
    echo "#include <vector>
      namespace flowcert { struct Twice { long members[$size]; };
                           void f$size(std::vector<Twice>& all) { all.push_back({}); } }" \
      >"$scratch/$size.cpp"
    "${CXX:-c++}" -std=c++20 -O0 -c "$scratch/$size.cpp" -o "$scratch/$size.o"
  done
  # "grep -q" ends at the first line it finds. What still writes to it would die of SIGPIPE, which pipefail sees.
  found=$(disagreements "$scratch" 2>/dev/null)
  grep -q 'flowcert::Twice' <<<"$found" ||
    { echo "FAIL: two types of one name are not found"; exit 1; }
  rm "$scratch/3.o"
  [ -z "$(disagreements "$scratch" 2>/dev/null)" ] || { echo "FAIL: one type is found to be two"; exit 1; }
  echo "ok"
  exit
fi

found=$(disagreements "$1" 2>"$1/symbols")
symbols=$(sed -n 's/^symbols: //p' "$1/symbols")
[ "$symbols" -gt 1000 ] || { echo "FAIL: only $symbols symbols of flowcert in $1: is it built?"; exit 1; }
[ -z "$found" ] || { echo "FAIL: symbols with several sizes: is a type defined twice?"; echo "$found"; exit 1; }
echo "$symbols weak symbols of flowcert, each of one size"
