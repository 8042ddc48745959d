#!/usr/bin/env bash
# ./dev fuzz: builds a target of fuzz/targets/ and runs it under libFuzzer or AFL++.
#
# usage: run.sh [TARGET [--time SECONDS] [--jobs N] [--afl]]      (without an argument: the targets, a line each)
#
# What a fuzzer learns stays in build-fuzz/corpus/ or build-afl/corpus/, what it finds in build-fuzz/findings/. Exit
# status: that of the fuzzer; 1 where something is found; 2 for wrong usage.
set -euo pipefail
cd "$(dirname "$0")/../.."

say() { printf '\n== %s\n' "$*"; }
usage() { echo "usage: ./dev fuzz TARGET [--time SECONDS] [--jobs N] [--afl]" >&2; exit 2; }

# build PRESET: the target, in build-PRESET/.
build() {
  say "building in build-$1/"
  cmake --preset "$1" >/dev/null
  cmake --build "build-$1" --parallel --target "fuzz_$target"
}

fuzz_targets() { (cd fuzz/corpus && printf '%s\n' *); }

list_fuzz_targets() {
  local target file
  for target in $(fuzz_targets); do
    file=fuzz/targets/$target.cpp
    case "$target" in
      read_xyz | read_off | read_ply | read_obj | read_pdb | read_mmcif) file=fuzz/targets/read_points.cpp ;;
      read_exchange | read_pockets | read_csv | read_giesen_kuehne | read_vtp) file=fuzz/targets/read_claims.cpp ;;
    esac
    printf '  %-20s %s\n' "$target" "$(sed -n '1s|^// ||p' "$file")"
  done
}

# What to do with the files in a folder of findings, if there are any.
tell_findings() {
  local target=$1 folder=$2
  [ -n "$(ls -A "$folder" 2>/dev/null)" ] || { say "nothing found"; return 0; }
  say "found, in $folder/"
  ls "$folder"
  cat <<TEXT
again, with the complaint:   build-fuzz/fuzz/fuzz_$target $folder/FILE
smaller:                     the same with  -minimize_crash=1 -runs=10000 -artifact_prefix=$folder/  before the file
without a fuzzer, by g++:    cmake --build build --target fuzz_$target && build/fuzz/fuzz_$target $folder/FILE
When it is mended, the file becomes a regression: put it in fuzz/corpus/$target/ under a name that says what was wrong.
TEXT
  return 1
}

# fuzz_by_libfuzzer TARGET SECONDS JOBS
fuzz_by_libfuzzer() {
  local target=$1 seconds=$2 workers=$3
  local corpus=build-fuzz/corpus/$target findings=build-fuzz/findings/$target
  build fuzz
  mkdir -p "$corpus" "$findings"
  local options=(-max_total_time="$seconds" -timeout=30 -print_final_stats=1 -artifact_prefix="$findings/")
  [ ! -f "fuzz/targets/$target.dict" ] || options+=(-dict="fuzz/targets/$target.dict")
  [ "$workers" -eq 1 ] || options+=(-fork="$workers" -ignore_crashes=0)
  say "libFuzzer on $target; what it learns stays in $corpus/"
  local status=0
  "build-fuzz/fuzz/fuzz_$target" "${options[@]}" "$corpus" "fuzz/corpus/$target" || status=$?
  tell_findings "$target" "$findings"
  return "$status"
}

# fuzz_by_afl TARGET SECONDS
fuzz_by_afl() {
  local target=$1 seconds=$2
  local out=build-afl/corpus/$target
  export AFL_QUIET=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_SKIP_CPUFREQ=1 AFL_NO_AFFINITY=1 AFL_NO_UI=1
  export AFL_AUTORESUME=1
  build afl
  local options=(-i "fuzz/corpus/$target" -o "$out" -m none -t 30000)
  [ "$seconds" -eq 0 ] || options+=(-V "$seconds")
  [ ! -f "fuzz/targets/$target.dict" ] || options+=(-x "fuzz/targets/$target.dict")
  mkdir -p build-afl/corpus
  say "AFL++ on $target; what it learns stays in $out/"
  afl-fuzz "${options[@]}" -- "build-afl/fuzz/fuzz_$target"
  grep -E '^(run_time|execs_done|execs_per_sec|corpus_count|edges_found|saved_crashes|saved_hangs)' \
    "$out/default/fuzzer_stats"
  local findings=build-fuzz/findings/$target
  mkdir -p "$findings"
  find "$out/default/crashes" "$out/default/hangs" -name 'id*' -exec cp -t "$findings" {} +
  tell_findings "$target" "$findings"
}

[ $# -gt 0 ] || { say "targets: ./dev fuzz TARGET [--time SECONDS] [--jobs N] [--afl]"; list_fuzz_targets; exit; }
target=$1 seconds=0 workers=1 by_afl=0
shift
grep -qxF -- "$target" <<<"$(fuzz_targets)" || { echo "no target '$target'; there are:" >&2; list_fuzz_targets >&2; exit 2; }
while [ $# -gt 0 ]; do
  case "$1:${2:-}" in
    --afl:*) by_afl=1; shift; continue ;;
    --time:[0-9]*) seconds=$2 ;;
    --jobs:[1-9]*) workers=$2 ;;
    *) usage ;;
  esac
  shift 2
done
case "$seconds$workers" in *[!0-9]*) usage ;; esac
if [ "$by_afl" -eq 1 ]; then
  [ "$workers" -eq 1 ] || { echo "--jobs is for libFuzzer" >&2; exit 2; }
  fuzz_by_afl "$target" "$seconds"
else
  fuzz_by_libfuzzer "$target" "$seconds" "$workers"
fi
