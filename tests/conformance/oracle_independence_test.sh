#!/usr/bin/env bash
# The oracle shares nothing with the fast implementation: no source, no CGAL, no MPFR. flowcert-proof shares nothing with
# either, and needs GMP alone.
#
# usage: oracle_independence_test.sh BUILD_DIR      (a Ninja build in which the oracle is built)
#        oracle_independence_test.sh --self-test
#
# Judged by what the compiler really read (ninja's record of dependencies for the oracle's object files) and by the
# line that links the tool. It fails as well when these do not show the oracle's own files: then it has seen nothing.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")

# The test on builds that a script stands for: one in batches without precompiled headers, one that reads a header of
# src/, one that reads a header of the build folder, and one in which the oracle is not built.
if [ "$1" = --self-test ]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  batch=build/oracle/CMakeFiles/flowcert_oracle.dir/Unity/unity_0_cxx.cxx
  mkdir -p "$scratch/bin" "$scratch/${batch%/*}"
  cat >"$scratch/bin/ninja" <<'NINJA'
#!/bin/sh
if [ "$2 $3" = "commands flowcert-proof" ]; then
  echo "c++ -lgmpxx -lgmp -o flowcert-proof"
elif [ "$2" = commands ]; then
  echo "c++ -o oracle/CMakeFiles/flowcert_oracle.dir/all.cpp.o -c all.cpp"
  echo "c++ libflowcert_oracle.a -lgmp -o flowcert-oracle"
else
  echo "oracle/CMakeFiles/flowcert_oracle.dir/all.cpp.o: #deps 1, deps mtime 1 (VALID)"
  cat read
  echo "oracle/proof/CMakeFiles/flowcert_proof.dir/main.cpp.o: #deps 1, deps mtime 1 (VALID)"
  cat read_for_proof
fi
NINJA
  chmod +x "$scratch/bin/ninja"
  touch "$scratch/gmp.h"
  printf '    %s\n' "$root/oracle/proof/main.cpp" "$scratch/gmp.h" >"$scratch/build/read_for_proof"
  # says EXPECTED FILES…: what the test says of a build that reads these files.
  says() {
    local expected=$1 said
    shift
    printf '    %s\n' "$@" >"$scratch/build/read"
    said=$(PATH=$scratch/bin:$PATH bash "$0" "$scratch/build" 2>&1) || true
    grep -q "$expected" <<<"$said" || { echo "FAIL: not '$expected', but: $said"; exit 1; }
  }
  says 'none of src/, none of CGAL' "$root"/oracle/{,fast/,program/}*.cpp "$scratch/gmp.h" "$scratch/$batch"
  says 'the oracle includes .*/drivers.h, which is part of the fast' "$root"/oracle/{,fast/,program/}*.cpp \
    "$scratch/gmp.h" "$root/src/flow/drivers.h"
  says 'the oracle includes .*/made.h, which is not its own' "$root"/oracle/{,fast/,program/}*.cpp \
    "$scratch/gmp.h" "$scratch/build/made.h"
  says 'is the oracle built' "$scratch/gmp.h"
  printf '    %s\n' "$root/oracle/proof/main.cpp" "$root/oracle/orbit.h" >"$scratch/build/read_for_proof"
  says 'flowcert-proof includes .*/orbit.h' "$root"/oracle/{,fast/,program/}*.cpp "$scratch/gmp.h"
  printf '    %s\n' "$scratch/gmp.h" >"$scratch/build/read_for_proof"
  says 'is flowcert-proof built' "$root"/oracle/{,fast/,program/}*.cpp "$scratch/gmp.h"
  echo "judges builds without precompiled headers, and finds what is read of src/, what is made and what is not built"
  exit 0
fi

cd -P "$1"
failures=0
fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}

# The oracle's objects, and the precompiled headers that they are compiled with, if there are any. The compiler lists
# separately what it read for a precompiled header.
objects='^[^ ]*flowcert_oracle(_tool)?[.]dir/'
precompiled=$(ninja -t commands flowcert-oracle | grep -E -- ' -o [^ ]*flowcert_oracle(_tool)?\.dir/' |
  { grep -oP -- ' -include (-Xclang )?\K\S+' || true; } | sort -u)
for header in $precompiled; do objects+="|^$(realpath --relative-to=. "$header")[.](gch|pch):"; done

# Header and source files that these depend on, with all links and ".." resolved.
read_files=$(ninja -t deps | awk -v objects="$objects" '/^[^ ]/ { wanted = $0 ~ objects && !/STALE/ } /^ / && wanted { print $1 }' |
  sort -u | xargs -r realpath | sort -u)

for source in "$root"/oracle/{,fast/,program/}*.cpp; do
  grep -qxF "$source" <<<"$read_files" || fail "no dependencies of $source are known; is the oracle built?"
done
grep -q '/gmp\.h$' <<<"$read_files" || fail "gmp.h is not among the dependencies; the list cannot be right"

while read -r file; do
  case "$file" in
    "$root"/src/*) fail "the oracle includes $file, which is part of the fast implementation" ;;
    */CGAL/*) fail "the oracle includes $file of CGAL" ;;
    */mpfr.h) fail "the oracle includes $file" ;;
    "$root"/oracle/*) ;;
    "$PWD"/CMakeFiles/flowcert_precompiled_everywhere*.dir/cmake_pch.hxx*) ;;  # other libraries' headers, listed above
    "$PWD"/oracle/CMakeFiles/flowcert_oracle*.dir/Unity/unity_*.cxx) ;;  # files of the oracle, listed above
    "$PWD"/* | "$root"/*) fail "the oracle includes $file, which is not its own" ;;
  esac
done <<<"$read_files"

link_line=$(ninja -t commands flowcert-oracle | tail -n 1)
grep -q 'libflowcert_oracle\.a' <<<"$link_line" || fail "the link line does not name libflowcert_oracle.a: $link_line"
grep -q -- 'lgmp\|libgmp' <<<"$link_line" || fail "the link line does not name GMP: $link_line"
if grep -qiE 'libflowcert\.|-lflowcert\b|cgal|mpfr' <<<"$link_line"; then
  fail "the oracle is linked with the fast implementation, CGAL or MPFR: $link_line"
fi

proof_files=$(ninja -t deps | awk '/^[^ ]/ { wanted = /flowcert_proof[.]dir/ && !/STALE/ } /^ / && wanted { print $1 }' |
  sort -u | xargs -r realpath | sort -u)
grep -qxF "$root/oracle/proof/main.cpp" <<<"$proof_files" || fail "no dependencies are known; is flowcert-proof built?"
while read -r file; do
  case "$file" in
    "$root"/oracle/proof/*) ;;
    "$root"/* | "$PWD"/* | */CGAL/* | */boost/* | */mpfr.h) fail "flowcert-proof includes $file, which is not its own" ;;
  esac
done <<<"$proof_files"
link_line=$(ninja -t commands flowcert-proof | tail -n 1)
if grep -qiE 'libflowcert|lflowcert|cgal|mpfr|boost' <<<"${link_line//flowcert_proof/}"; then
  fail "flowcert-proof is linked with more than GMP: $link_line"
fi

[ "$failures" -eq 0 ] || exit 1
echo "the oracle reads $(wc -l <<<"$read_files") files; none of src/, none of CGAL"
