#!/usr/bin/env bash
# The time of λ-lists and of all stable sets with their volumes against CGAL's Delaunay triangulation: medians of five
# runs, one thread. Volumes need the limits, so the column "S3" is the sum of both. Then whether the regions of all
# Voronoi facets tile them, and volumes add up, modulo three primes. Last the bunny's exports: seconds of the whole run,
# peak memory, and the size of the files; `none` computes alone. The inputs: the Stanford bunny of glmark2-data, and
# every .xyz file of a folder, if one is given. usage: whole_complex.sh PROGRAM FACET_TILING [FOLDER]
set -euo pipefail
program=$1
tiling=$2
folder=${3:-}

inputs=(/usr/share/glmark2/models/bunny.obj)
[ -z "$folder" ] || inputs+=("$folder"/*.xyz)

printf '%-18s %8s %14s %9s %9s %9s %9s %11s %9s %8s\n' input points 'Delaunay [ms]' 'limits [x]' 'S3 [x]' lists directions \
  arcs 'by exact' 'MiB'
for input in "${inputs[@]}"; do
  "$program" compute --manifolds all --threads 1 --json --runs 5 "$input" | python3 -c '
import json, os, sys
d = json.load(sys.stdin)
w, x = d["whole_complex"], d["ratio_to_delaunay"]
print("%-18s %8d %14.1f %10.2f %9.2f %9d %9d %11d %9d %8.0f" % (
    os.path.basename(sys.argv[1]), d["points"], 1000 * d["seconds"]["delaunay"], x["limits"],
    x["limits"] + x["volumes"], w["lists"], w["directions"], w["arcs"], w["volumes_decided_exactly"],
    d["peak_memory_bytes"] / 2**20))' "$input"
done
for input in "${inputs[@]}"; do
  printf '\n%s\n' "$(basename "$input")"
  "$tiling" "$input"
done

files=$(mktemp -d)
trap 'rm -rf "$files"' EXIT
printf '\n%-18s %10s %10s %10s\n' export seconds 'MiB' 'files[MB]'
for only in none fans cells infinity sheets; do
  words=()
  [ "$only" = none ] || words=(--export "$files/$only" --only "$only")
  begun=$EPOCHREALTIME
  peak=$("$program" compute --manifolds all --threads 1 --json "${words[@]}" "${inputs[0]}" | python3 -c '
import json, sys
print(json.load(sys.stdin)["peak_memory_bytes"] / 2**20)')
  ended=$EPOCHREALTIME
  size=0
  [ "$only" = none ] || size=$(du -sb "$files/$only" | cut -f 1)
  python3 -c 'import sys; print("%-18s %10.1f %10.0f %10.0f" % (sys.argv[1], float(sys.argv[2]) - float(sys.argv[3]),
                                                   float(sys.argv[4]), int(sys.argv[5]) / 1e6))' \
    "$only" "$ended" "$begun" "$peak" "$size"
  rm -rf "${files:?}/$only"
done
