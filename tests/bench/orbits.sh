#!/usr/bin/env bash
# The time of the unstable manifolds U2 of all index-2 points against CGAL's Delaunay triangulation, with orbits that share what follows a
# common Voronoi vertex and with each alone, as the paper computed them; medians of five interleaved runs, one thread. The inputs: kitten.xyz of Debian's
# libcgal-demo, the Stanford bunny of glmark2-data, and from a folder, if one is given, kitten.xyz and dragon_res3.xyz.
# usage: orbits.sh PROGRAM [FOLDER]
set -euo pipefail
program=$1
folder=${2:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The package has its data in an archive.
kitten() {
  if [ -n "$folder" ] && [ -f "$folder/kitten.xyz" ]; then
    echo "$folder/kitten.xyz"
    return
  fi
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz
  if [ -f "$archive" ] && tar -xzf "$archive" -C "$scratch" data/points_3/kitten.xyz; then
    echo "$scratch/data/points_3/kitten.xyz"
  fi
}

inputs=()
for input in "$(kitten)" "${folder:+$folder/dragon_res3.xyz}" /usr/share/glmark2/models/bunny.obj; do
  if [ -n "$input" ] && [ -f "$input" ]; then inputs+=("$input"); fi
done

# Points, seconds of the triangulation, multiple of it for U2, mean and max of n_U2.
figures() {
  "$program" compute --manifolds u2 --stats --json --runs 5 "$@" | tr ',{}' '\n' | awk -F: '
    { gsub(/["\[\] ]/, "", $1); gsub(/["\]\[ ]/, "", $2) }
    $2 == "" { part = $1 }
    $1 == "points" { points = $2 }
    part == "seconds" && $1 == "delaunay" { delaunay = $2 }
    part == "ratio_to_delaunay" && $1 == "u2" && $2 != "" { ratio = $2 }
    part == "n_u2" && $1 == "mean" { mean = $2 }
    part == "n_u2" && $1 == "max" { max = $2 }
    END { print points, delaunay, ratio, mean, max }'
}

printf '%-18s %8s %14s %14s %14s %13s %10s %9s\n' input points 'Delaunay [ms]' 'U2 shared [x]' 'U2 alone [x]' 'alone/shared' \
  'n_U2 mean' 'n_U2 max'
for input in "${inputs[@]}"; do
  with_sharing=$(figures "$input")
  without=$(figures "$input" --alone)
  read -r points delaunay shared mean max <<<"$with_sharing"
  read -r _ _ alone _ <<<"$without"
  awk -v name="$(basename "$input")" -v points="$points" -v delaunay="$delaunay" -v shared="$shared" -v alone="$alone" \
    -v mean="$mean" -v max="$max" 'BEGIN {
      printf "%-18s %8d %14.1f %14.2f %14.2f %13.2f %10.2f %9d\n", name, points, 1000 * delaunay, shared, alone,
        alone / shared, mean, max
    }'
done
