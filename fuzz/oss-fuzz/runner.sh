#!/usr/bin/env bash
# Runs the fuzz targets that builder.sh made, on a bare Debian as root that has nothing but them and what unpacks seeds:
# ./dev fuzz --oss calls it in a root of its own.
#
# usage: runner.sh FOLDER SECONDS
#
# Every target of each sanitizer runs so long from its seeds, with the options of OSS-Fuzz's image base-runner. A line
# each: seeds, executions, edges at the start and at the end. Exit status: 1 where something is found, where a target
# runs no seed, or needs a library that is not C's.
set -euo pipefail
shopt -s failglob  # a folder without targets is a fault
folder=$(realpath "$1") seconds=$2 status=0
scratch=$(mktemp -d)
apt-get -qq update
DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends binutils unzip >/dev/null

export ASAN_OPTIONS=alloc_dealloc_mismatch=0:allocator_may_return_null=1:allocator_release_to_os_interval_ms=500
ASAN_OPTIONS+=:check_malloc_usable_size=0:detect_container_overflow=1:detect_odr_violation=0:detect_leaks=1
ASAN_OPTIONS+=:detect_stack_use_after_return=1:fast_unwind_on_fatal=0:handle_abort=1:handle_segv=1:handle_sigill=1
ASAN_OPTIONS+=:max_uar_stack_size_log=16:print_scariness=1:quarantine_size_mb=10:strict_memcmp=1:use_sigaltstack=1
export UBSAN_OPTIONS=print_stacktrace=1:print_summary=1:silence_unsigned_overflow=1

fault() { echo "FAULT: $*"; status=1; }
# The first or last number after a word in the log.
number() { { grep -oE "$1 +[0-9]+" "$scratch/log" || echo 0; } | "$2" -n 1 | grep -oE '[0-9]+$'; }

for program in "$folder"/*/fuzz_*[a-z]; do
  case "$program" in *.dict | *.options | *.zip) continue ;; esac
  name=${program##*/} sanitizer=$(basename "$(dirname "$program")")
  foreign=$(readelf -d "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
    grep -vE '^(lib(c|dl|gcc_s|m|pthread|resolv|rt)\.so\.[0-9]+|ld-linux.*)$' || true)
  [ -z "$foreign" ] || fault "$sanitizer/$name needs $foreign"
  seeds=$scratch/$sanitizer/$name
  mkdir -p "$seeds" "$seeds.new"
  unzip -q "${program}_seed_corpus.zip" -d "$seeds"
  options=(-rss_limit_mb=2560 "-max_total_time=$seconds" -print_final_stats=1 "-artifact_prefix=$seeds.found-")
  while IFS=' =' read -r option value; do options+=("-$option=$value"); done < <(grep = "$program.options")
  [ ! -f "$program.dict" ] || options+=("-dict=$program.dict")
  result=0
  "$program" "${options[@]}" "$seeds.new" "$seeds" >"$scratch/log" 2>&1 || result=$?
  [ "$result" -eq 0 ] || { tail -n 60 "$scratch/log"; fault "$sanitizer/$name ends with $result"; }
  count=$(find "$seeds" -type f | wc -l)
  grep -qE "INITED.* cov: [1-9]" "$scratch/log" || fault "$sanitizer/$name runs no seed"
  printf '%-9s  %-24s  %3d seeds  %9d runs  edges %5d to %5d  %4d MB\n' "$sanitizer" "$name" "$count" \
    "$(number stat::number_of_executed_units: tail)" "$(number cov: head)" "$(number cov: tail)" \
    "$(number stat::peak_rss_mb: tail)"
done
exit "$status"
