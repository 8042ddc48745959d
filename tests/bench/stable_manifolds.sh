#!/usr/bin/env bash
# The time of the stable manifolds S2 of all index-2 points against CGAL's Delaunay triangulation: medians of five
# runs, in turn, one thread, cascade kernel. The inputs: the Stanford bunny of glmark2-data, and from a folder, if one
# is given, dragon_res2.xyz and building.xyz. usage: stable_manifolds.sh PROGRAM [FOLDER]
set -euo pipefail
program=$1
folder=${2:-}

inputs=()
for input in /usr/share/glmark2/models/bunny.obj "${folder:+$folder/dragon_res2.xyz}" "${folder:+$folder/building.xyz}"; do
  if [ -n "$input" ] && [ -f "$input" ]; then inputs+=("$input"); fi
done

printf '%-18s %8s %14s %9s %12s %10s %9s %12s %13s %13s\n' input points 'Delaunay [ms]' 'S2 [x]' 'triangles' 'n_S2 mean' 'n_S2 max' \
  'largest S2' 'with vertex' 'to regular'
for input in "${inputs[@]}"; do
  "$program" compute --manifolds s2 --threads 1 --stats --json --runs 5 "$input" | tr ',{}' '\n' | awk -F: -v name="$(basename "$input")" '
    { gsub(/["\[\] ]/, "", $1); gsub(/["\]\[ ]/, "", $2) }
    $2 == "" { part = $1 }
    $1 == "points" { points = $2 }
    part == "seconds" && $1 == "delaunay" { delaunay = $2 }
    part == "ratio_to_delaunay" && $1 == "s2" { ratio = $2 }
    part == "s2" && $1 == "triangles" { triangles = $2 }
    part == "s2" && $1 == "largest_triangles" { largest = $2 }
    $1 == "through_vertex" { vertex = $2 }
    $1 == "to_regular" { regular = $2 }
    part == "n_s2" && $1 == "mean" { mean = $2 }
    part == "n_s2" && $1 == "max" { max = $2 }
    END {
      printf "%-18s %8d %14.1f %9.2f %12d %10.2f %9d %12d %13d %13d\n", name, points, 1000 * delaunay, ratio, triangles, mean, max, largest, vertex, regular
    }'
done
