#!/usr/bin/env bash
# The README's library example, as a user would meet it: the build is installed into an empty folder, the example's own blocks are taken
# out of the README, configured with find_package(flowcert) outside of the tree, built and run, and print what the README says.
# usage: install_test.sh BUILD-FOLDER
set -euo pipefail
build=$1
readme="$(cd "$(dirname "$0")/../.." && pwd)/README.md"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The fenced block that follows the line <!-- example: NAME -->.
block() {
  awk -v mark="<!-- example: $1 -->" '
    $0 == mark { wanted = 1; next }
    wanted && /^```/ { if (inside) exit; inside = 1; next }
    inside { print }' "$readme" >"$2"
  [ -s "$2" ] || { echo "README.md has no block after <!-- example: $1 -->"; exit 1; }
}

cmake --install "$build" --prefix "$folder/prefix" >"$folder/install.log"
mkdir "$folder/example"
block cmake "$folder/example/CMakeLists.txt"
block library "$folder/example/example.cpp"
block output "$folder/expected"

if grep -rn '#include <CGAL/' "$folder/prefix/include"; then
  echo "a public header includes CGAL"
  exit 1
fi
cmake -S "$folder/example" -B "$folder/example/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
cmake --build "$folder/example/build"
"$folder/example/build/example" >"$folder/printed"
diff "$folder/expected" "$folder/printed"
"$folder/prefix/bin/flowcert" --version
