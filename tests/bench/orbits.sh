#!/usr/bin/env bash
# The time of the unstable manifolds U2 of all index-2 points against CGAL's Delaunay triangulation: by the cascade
# kernel with orbits that share what follows a common Voronoi vertex and with each alone, as the paper computed them,
# and by the lazy kernel with sharing; medians of five runs of each, in turn, one thread.
# The inputs: kitten.xyz of Debian's libcgal-demo, the Stanford bunny of
# glmark2-data, and from a folder, if one is given, kitten.xyz and dragon_res3.xyz. usage: orbits.sh PROGRAM [FOLDER]
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

# Points, seconds of the triangulation, seconds of U2, mean and max of n_U2, of one run.
figures() {
  "$program" compute --manifolds u2 --threads 1 --stats --json "$@" | tr ',{}' '\n' | awk -F: '
    { gsub(/["\[\] ]/, "", $1); gsub(/["\]\[ ]/, "", $2) }
    $2 == "" { part = $1 }
    $1 == "points" { points = $2 }
    part == "seconds" && $1 == "delaunay" { delaunay = $2 }
    part == "seconds" && $1 == "u2" && $2 != "" { u2 = $2 }
    part == "n_u2" && $1 == "mean" { mean = $2 }
    part == "n_u2" && $1 == "max" { max = $2 }
    END { print points, delaunay, u2, mean, max }'
}

printf '%-18s %8s %14s %11s %10s %9s %11s %13s %10s %9s\n' input points 'Delaunay [ms]' 'cascade [x]' 'alone [x]' 'lazy [x]' \
  'lazy/shared' 'alone/shared' 'n_U2 mean' 'n_U2 max'
for input in "${inputs[@]}"; do
  for run in 1 2 3 4 5; do
    echo "shared $(figures "$input")"
    echo "alone $(figures "$input" --alone)"
    echo "lazy $(figures "$input" --kernel lazy)"
  done | awk -v name="$(basename "$input")" '
    function median(list, n,    i, j, swap) {
      for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (list[j] < list[i]) { swap = list[i]; list[i] = list[j]; list[j] = swap }
      return (list[int((n + 1) / 2)] + list[int(n / 2) + 1]) / 2
    }
    { delaunay[++all] = $3 }
    $1 == "shared" { shared[++a] = $4 }
    $1 == "alone" { alone[++b] = $4 }
    $1 == "lazy" { lazy[++c] = $4 }
    END {
      d = median(delaunay, all); s = median(shared, a); t = median(alone, b); l = median(lazy, c)
      printf "%-18s %8d %14.1f %11.2f %10.2f %9.1f %11.1f %13.2f %10.2f %9d\n", name, $2, 1000 * d, s / d, t / d, l / d,
        l / s, t / s, $5, $6
    }'
done
