#!/usr/bin/env bash
# package_test.sh FLOWCERT: the tests of the npm package that ./dev wasm made of this commit, against the program.
#
# Exit status 77, which ctest takes for skipped, and a line that says what is missing, where there is no such package.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
skip() { echo "package_test: skipped: $*"; exit 77; }

command -v node >/dev/null || skip "there is no node"
package=$(ls "$root"/build-wasm/npm/*.tgz 2>/dev/null) || skip "no build-wasm/npm/*.tgz: ./dev wasm makes it"
commit=$(cat "$root/build-wasm/npm/commit")
[ "$commit" = "$(git -C "$root" rev-parse HEAD)" ] ||
  skip "build-wasm/npm is of commit $commit: ./dev wasm makes it anew"
FLOWCERT=$1 FLOWCERT_TGZ=$package FLOWCERT_TSC=$(command -v tsc || true) exec node --test "$root/tests/web_module/"
