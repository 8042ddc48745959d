#!/usr/bin/env bash
# The installed library is what src/README.md says: its example, copied out of it, builds against an installed copy with
# find_package alone, outside the tree, and prints what it says there.
#
# usage: install_test.sh BUILD_DIR      (a build of this tree, with the library and the program built)
#
# The three fenced blocks are those after the lines `<!-- example: cmake -->`, `<!-- example: library -->` and
# `<!-- example: output -->`. It fails as well when one of them is missing, and when an installed header needs CGAL,
# does not compile, or is reached from no example.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
build=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
  echo "FAIL: $*"
  exit 1
}

# The lines between the fences of the block after <!-- example: NAME -->.
block() {
  awk -v mark="<!-- example: $1 -->" '
    inside && /^```/ { exit }
    inside { print }
    marked && /^```/ { inside = 1; marked = 0 }
    $0 == mark { marked = 1 }' "$root/${2:-src/README.md}"
}

# A variable of the build's cache.
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

# Runs a command; what it says is shown only if it fails.
quietly() { "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$*"; }; }

mkdir "$scratch/example"
block cmake >"$scratch/example/CMakeLists.txt"
block library >"$scratch/example/example.cpp"
block output >"$scratch/expected"
for file in example/CMakeLists.txt example/example.cpp expected; do
  [ -s "$scratch/$file" ] || fail "src/README.md has no block for $file"
done
grep -q 'find_package(flowcert' "$scratch/example/CMakeLists.txt" || fail "the example does not use find_package"

quietly cmake --install "$build" --prefix "$scratch/prefix"
headers=$(find "$scratch/prefix/include/flowcert" -name '*.h' | wc -l)
[ "$headers" -gt 0 ] || fail "no header is installed"
! grep -rn 'include.*CGAL' "$scratch/prefix/include" || fail "an installed header includes CGAL"
for header in "$root"/src/*/include/flowcert/*.h; do
  [ -f "$scratch/prefix/include/flowcert/$(basename "$header")" ] || fail "$header is not installed"
done
# An example includes each of them, or Python's binding does, itself or by another header.
included_by() { cat "$@" | sed -n 's/^#include ["<]flowcert\/\([a-z0-9_]*\.h\)[">].*/\1/p' | sort -u; }
included_by "$scratch/example/example.cpp" "$root"/src/python/*.{h,cpp} >"$scratch/reached"
while true; do
  (cd "$scratch/prefix/include/flowcert" && mapfile -t reached <"$scratch/reached" && included_by "${reached[@]}") |
    sort -u - "$scratch/reached" >"$scratch/further"
  cmp -s "$scratch/further" "$scratch/reached" && break
  mv "$scratch/further" "$scratch/reached"
done
ls "$scratch/prefix/include/flowcert" | diff - "$scratch/reached" || fail "headers that no example reaches are installed"
"$scratch/prefix/bin/flowcert" --version >"$scratch/version" || fail "the installed program does not run"
# The oracle is no program for users, and stays in the build.
[ "$(ls "$scratch/prefix/bin" | grep -v flowcert-fuzz-mpi | xargs)" = "flowcert flowcert-proof" ] ||
  fail "other programs are installed"
for file in bash-completion/completions/flowcert zsh/site-functions/_flowcert fish/vendor_completions.d/flowcert.fish \
  man/man1/flowcert.1 man/man1/flowcert-fuzz-merge.1 man/man1/flowcert-proof.1; do
  [ -s "$scratch/prefix/share/$file" ] || fail "share/$file is not installed"
done
"$scratch/prefix/bin/flowcert" completion bash | cmp - "$scratch/prefix/share/bash-completion/completions/flowcert" ||
  fail "the installed completion is another program's"
! grep -rlF -e "$root" -e "$build" "$scratch/prefix/lib/"*/cmake "$scratch/prefix/lib/cmake" 2>/dev/null ||
  fail "the installed package refers to the tree that it was built in"

# What is linked with an instrumented library needs the same flags.
flags=
case "$(cached FLOWCERT_SANITIZE)" in ON) flags='-fsanitize=address,undefined' ;; esac
case "$(cached FLOWCERT_COVERAGE)" in ON) flags='--coverage' ;; esac
quietly cmake -S "$scratch/example" -B "$scratch/example/build" -G Ninja -DCMAKE_PREFIX_PATH="$scratch/prefix" \
  -DCMAKE_CXX_COMPILER="$(cached CMAKE_CXX_COMPILER)" -DCMAKE_CXX_FLAGS="$flags -Wall -Wextra"
found=$(sed -n 's/^flowcert_DIR:PATH=//p' "$scratch/example/build/CMakeCache.txt")
case "$found" in "$scratch"/*) ;; *) fail "another flowcert was found: $found" ;; esac
quietly cmake --build "$scratch/example/build"
"$scratch/example/build/example" >"$scratch/printed" || fail "the example does not run"
diff -u "$scratch/expected" "$scratch/printed" || fail "the example prints something else"
# The generators are a component of their own.
mkdir "$scratch/generators"
block generators fuzz/README.md >"$scratch/generators/generators.cpp"
[ -s "$scratch/generators/generators.cpp" ] || fail "fuzz/README.md has no example of generators"
cat >"$scratch/generators/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(generators CXX)
set(CMAKE_CXX_STANDARD 20)
find_package(flowcert REQUIRED COMPONENTS generators)
add_executable(generators generators.cpp headers.cpp)
target_link_libraries(generators flowcert::generators flowcert::flowcert)
TEXT
# Every header that is installed compiles.
(cd "$scratch/prefix/include/flowcert-generators" && find fuzz -name '*.h') | sed 's/.*/#include "&"/' \
  >"$scratch/generators/headers.cpp"
(cd "$scratch/prefix/include" && find flowcert -name '*.h') | sed 's/.*/#include "&"/' >>"$scratch/generators/headers.cpp"
grep -q input_points "$scratch/generators/headers.cpp" || fail "no conversion to the library's points is installed"
quietly cmake -S "$scratch/generators" -B "$scratch/generators/build" -G Ninja -DCMAKE_PREFIX_PATH="$scratch/prefix" \
  -DCMAKE_CXX_COMPILER="$(cached CMAKE_CXX_COMPILER)" -DCMAKE_CXX_FLAGS="$flags -Wall -Wextra"
quietly cmake --build "$scratch/generators/build"
"$scratch/generators/build/generators" >"$scratch/printed_by_generators" || fail "the generators' example does not run"
grep -q '^general-position: [0-9]* points$' "$scratch/printed_by_generators" || fail "the generators draw something else"
echo "the example builds against the installed library and prints its $(wc -l <"$scratch/expected") lines"
