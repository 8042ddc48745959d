#!/usr/bin/env bash
# gmp_tests.sh FOLDER: GMP's own tests of mpn and mpz, under Node, of what src/web/libraries.sh has built in FOLDER.
# clang links them with emscripten's C library, and Node gives them WASI: em++ would take ten times as long. Memory does
# not grow there, and the tests put large numbers on the stack. setjmp, which is there for signals that never come, is
# left to run_wasi.mjs.
set -euo pipefail
# Four tests are expected to fail: three want files, which the program has by JavaScript alone, and one calls a function
# by another signature, which WebAssembly does not let it.
failing='io t-inp_str t-io_raw t-nextprime'
here=$(cd "$(dirname "$0")" && pwd)
cd "$1-build/gmp/tests"
make -j "$(nproc)" libtests.la >/dev/null 2>&1
for part in mpn mpz; do
  make -j "$(nproc)" -C $part check LDFLAGS=-Wl,--allow-undefined,--initial-memory=536870912,-z,stack-size=8388608 \
    XFAIL_TESTS="$failing" LOG_COMPILER="node --no-warnings $here/run_wasi.mjs" >$part.log 2>&1 || true
  awk -v part=$part '/^# [A-Z]+:/ { said = said " " $2 " " $3; if ($2 ~ /^(FAIL|XPASS|ERROR)/) bad += $3 }
    END { print "GMP, " part ":" said; exit bad > 0 || said == "" }' $part.log ||
    { grep -E '^(FAIL|XPASS|ERROR|make)' $part.log >&2; exit 1; }
done
