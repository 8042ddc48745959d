#!/usr/bin/env bash
# ./dev coverage: runs all tests of an instrumented build, and prints how much of src/, oracle/ and what judges they
# reach.
#
# usage: coverage.sh BUILD_DIR      (relative to the top folder)
#
# Exit status 1 where less is reached than asked.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1

say() { printf '\n== %s\n' "$*"; }

# at_least WHAT PERCENT ASKED
at_least() {
  echo "$1 covered: $2 % (at least $3 % asked)"
  awk -v p="$2" -v asked="$3" 'BEGIN { exit !(p >= asked) }'
}

lcov=(lcov --quiet --rc lcov_branch_coverage=0)
"${lcov[@]}" --zerocounters --directory "$build"
FLOWCERT_PROPERTY_SCALE=${FLOWCERT_PROPERTY_SCALE:-0.1} ctest --preset coverage --parallel "$(nproc)"
"${lcov[@]}" --capture --directory "$build" --output-file "$build/all.info"
"${lcov[@]}" --extract "$build/all.info" "$PWD/src/*" "$PWD/oracle/*" "$PWD/fuzz/judge/*" "$PWD/fuzz/commands/*" \
  --output-file "$build/coverage.info"
genhtml --quiet --output-directory "$build/report" "$build/coverage.info"
# lcov counts the edges of exceptions as branches. gcovr knows the branches that the code has itself.
gcovr --root . --filter src/ --filter oracle/ --filter fuzz/judge/ --filter fuzz/commands/ \
  --exclude-throw-branches --branches \
  --json-summary-pretty --json-summary "$build/branches.json" --txt "$build/branches.txt" "$build"
say "line coverage of src/, oracle/, fuzz/judge/, fuzz/commands/ ($build/report/index.html; branches: $build/branches.txt)"
lcov --list "$build/coverage.info"
status=0
lines=$(lcov --summary "$build/coverage.info" 2>&1 | sed -n 's/.*lines[.]*: \([0-9.]*\)%.*/\1/p')
branches=$(sed -n '/"branch_percent"/ { s/.*: \([0-9.]*\).*/\1/p; q }' "$build/branches.json")  # the files follow
at_least lines "$lines" 97 || status=1
at_least branches "$branches" 85 || status=1
exit "$status"
