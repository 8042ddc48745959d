#!/usr/bin/env bash
# The time of the critical points against CGAL's Delaunay triangulation, medians of nine interleaved runs, one
# thread, for the Stanford bunny of Debian's glmark2-data and for every .xyz file of a folder, if one is given.
# usage: critical_points.sh PROGRAM [FOLDER]
set -euo pipefail
program=$1
inputs=(/usr/share/glmark2/models/bunny.obj)
if [ -n "${2:-}" ]; then inputs+=("$2"/*.xyz); fi

printf '%-22s %9s %6s %14s %14s %7s %s\n' input points Euler 'Delaunay [ms]' 'critical [ms]' ratio 'filter failures/calls: angle, side, cospherical'
for input in "${inputs[@]}"; do
  "$program" compute "$input" --threads 1 --runs 9 --json | tr ',{}' '\n' | awk -v name="$(basename "$input")" -F: '
    { gsub(/["\[\] ]/, "", $1); gsub(/["\]\[ ]/, "", $2) }
    $1 == "seconds" || $1 == "ratio_to_delaunay" || $1 == "filters" { part = $1 }
    $1 == "points" { points = $2 }
    $1 == "euler" { euler = $2 }
    part == "seconds" && $1 == "delaunay" { delaunay = 1000 * $2 }
    part == "seconds" && $1 == "critical" { critical = 1000 * $2 }
    part == "ratio_to_delaunay" && $1 == "critical" { ratio = $2 }
    $1 == "angle" || $1 == "side_of_plane" || $1 == "cospherical" || $1 == "coplanar" || $1 == "cocircular" { predicate = $1 }
    $1 == "calls" { calls[predicate] = $2 }
    $1 == "failures" { failures[predicate] = $2 }
    END {
      printf "%-22s %9d %6d %14.1f %14.1f %7.2f %d/%d, %d/%d, %d/%d\n", name, points, euler, delaunay, critical, ratio,
        failures["angle"], calls["angle"], failures["side_of_plane"], calls["side_of_plane"],
        failures["cospherical"], calls["cospherical"]
    }'
done
