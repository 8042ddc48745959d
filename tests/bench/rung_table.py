#!/usr/bin/env python3
"""Which precision decides the signs of U2, and the time with and without those between doubles and exact integers.

usage: rung_table.py CASCADE_RUNGS [--limit SECONDS] [SCAN ...]

CASCADE_RUNGS is that program. The inputs are the scans, with kitten.xyz of Debian's libcgal-demo if none has that name,
each scan rounded to a grid, half spheres with and without noise, a half shell, long cascades and the capsule. Times are
multiples of CGAL's Delaunay triangulation in the same run; a run over the limit, 600 seconds, is an x.
Guarantees: whatever rungs are asked, as many signs are asked for; each is decided by one rung.
Exit status: 0; 1 where the rungs' counts do not add up, or the program fails; 2 for bad usage.
"""
import argparse
import pathlib
import sys
import tempfile

from paper_tables import Failure, kitten, print_table, run

CHOICES = {"none": "doubles -> integers", "doubled": "doubles -> doubled -> integers",
           "extended": "doubles -> 256 bits -> integers", "both": "all four"}
MADE = ("half-sphere:10000", "half-sphere:33711", "noisy:10000", "noisy:33711", "half-shell:33711", "cascade:124",
        "cascade:1174", "cascade:11674", "capsule:1000")


def row_of(options, name, choice):
    text = run([options.program, choice, name], options.limit)
    label = pathlib.Path(name).name if not name.startswith("grid:") else f"grid:{pathlib.Path(name[5:]).name}"
    print(f"  {label}, {choice}: {'x' if text is None else text.strip()}", file=sys.stderr, flush=True)
    if text is None:
        return None, [label, CHOICES[choice], *["x"] * 6]
    words = text.split()
    asked, *decided = map(int, words[1:6])
    if sum(decided) != asked:
        raise Failure(f"{name}: {asked} signs, but {sum(decided)} are decided")
    seconds, triangulation = map(float, words[6:])
    return asked, [label, CHOICES[choice], *decided, f"{1e3 * seconds:,.1f}", f"{seconds / triangulation:,.2f}"]


def rows_of(options):
    rows = []
    for name in [*options.scans, *[f"grid:{scan}" for scan in options.scans], *MADE]:
        asked = set()
        for choice in CHOICES:
            count, row = row_of(options, name, choice)
            rows.append(row)
            asked |= {count} - {None}
        if len(asked) > 1:
            raise Failure(f"{name}: other rungs, other signs: {sorted(asked)}")
    return rows


def main():
    parser = argparse.ArgumentParser(description="which precision decides the signs of orbits")
    parser.add_argument("program", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("scans", nargs="*")
    parser.add_argument("--limit", type=float, default=600, help="seconds of a run (600)")
    options = parser.parse_intermixed_args()
    with tempfile.TemporaryDirectory() as scratch:
        if all(pathlib.Path(scan).stem != "kitten" for scan in options.scans):
            options.scans = [*map(str, kitten(pathlib.Path(scratch))), *options.scans]
        try:
            rows = rows_of(options)
        except Failure as failure:
            print("error:", failure, file=sys.stderr)
            return 1
    print_table("Signs by the rung that decided them, and the time of U2",
                ["input", "rungs", "doubles", "doubled", "256 bits", "integers", "U2 [ms]", "x Delaunay"], rows, 2)
    return 0


if __name__ == "__main__":
    sys.exit(main())
