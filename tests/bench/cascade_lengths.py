#!/usr/bin/env python3
"""Time, and bits of exact numbers, by the length of a cascade, for all three kernels.

usage: cascade_lengths.py PROGRAM GENERATOR PICTURES [--limit SECONDS] [--longest N]

PROGRAM is flowcert, GENERATOR is write_configuration, PICTURES a folder for two plots as SVG files. A cascade is one
of `long_cascade` in fuzz/inputs/large_configurations.h: the flow goes from facet to facet and meets no Voronoi vertex.
Times are of all unstable manifolds, which are hardly more than the cascade, as ratios to CGAL's Delaunay triangulation
in the same run. A run over the limit, 600 seconds, is an x.
Guarantees: every cascade is at least as long as its line says, and the kernels agree about its length.
Exit status: 0; 1 where a cascade is too short, two kernels disagree, or a program fails; 2 for bad usage.
"""
import argparse
import json
import math
import pathlib
import sys
import tempfile

from paper_tables import Failure, KERNELS, cell, print_table, run

LENGTHS = (10, 30, 100, 300, 1000, 3000, 10000)
COLORS = {"cascade": "#4477aa", "lazy": "#cc6677", "exact": "#228833"}


def points_for(length):
    """The first facets of the strip are crossed from vertex to vertex, about an eighth of all."""
    return length + length // 6 + 8


def measured(options, length, scratch):
    """What `stats` says of a cascade, by kernel; None for an x."""
    points = scratch / f"cascade-{length}.xyz"
    points.write_text(run([options.generator, "long-cascade", str(points_for(length))], None))
    found = {}
    for kernel in KERNELS:
        text = run([options.program, "stats", points, "--manifolds", "u2", "--threads", "1", "--json", "--kernel",
                    kernel], options.limit)
        found[kernel] = None if text is None else json.loads(text)
        print(f"  {length}, {kernel}: {'x' if text is None else 'done'}", file=sys.stderr, flush=True)
    reached = {one["u2"]["n_wcc"]["max"] for one in found.values() if one}
    if len(reached) != 1:
        raise Failure(f"the kernels disagree about the cascade of {length}: {sorted(reached)}")
    if min(reached) < length:
        raise Failure(f"the cascade of {length} has a length of {min(reached)}")
    return found


def rows_of(all_found, pick, form):
    rows = []
    for length, found in all_found.items():
        one = found["cascade"] or found["lazy"] or found["exact"]
        rows.append([length, one["points"], one["u2"]["n_wcc"]["max"],
                     *[cell(pick(found[kernel]) if found[kernel] else None, form) for kernel in KERNELS]])
    return rows


def seconds(result):
    return result["seconds"]["u2"]


def bits(result):
    return 8 * result["u2"]["exact_bytes"]["max"]


# ---- The plots ----

LEFT, RIGHT, TOP, BOTTOM = 80, 560, 40, 360


def decades(values):
    """The powers of ten around positive values."""
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))


def plot(title, label, series):
    """A plot with logarithmic axes: for each name, pairs of positive numbers."""
    pairs = [pair for line in series.values() for pair in line]
    ranges = [decades([pair[axis] for pair in pairs]) for axis in (0, 1)]
    ranges = [(low, max(high, low + 1)) for low, high in ranges]

    def place(value, axis):
        low, high = ranges[axis]
        share = (math.log10(value) - low) / (high - low)
        return LEFT + share * (RIGHT - LEFT) if axis == 0 else BOTTOM - share * (BOTTOM - TOP)

    out = ['<svg xmlns="http://www.w3.org/2000/svg" width="680" height="420" font-family="sans-serif" font-size="12">',
           '<rect width="680" height="420" fill="white"/>', f'<text x="{LEFT}" y="24" font-size="15">{title}</text>']
    for axis in (0, 1):
        for power in range(ranges[axis][0], ranges[axis][1] + 1):
            at = place(10.0 ** power, axis)
            ends = (at, BOTTOM, at, TOP) if axis == 0 else (LEFT, at, RIGHT, at)
            out.append('<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="#dddddd"/>'.format(*ends))
            where = (at, BOTTOM + 18, "middle") if axis == 0 else (LEFT - 8, at + 4, "end")
            out.append('<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>'.format(*where, f"{10.0 ** power:g}"))
    for name, line in series.items():
        if not line:
            continue
        at = [(place(x, 0), place(y, 1)) for x, y in line]
        out.append('<polyline points="{}" fill="none" stroke="{}" stroke-width="2"/>'.format(
            " ".join(f"{x:.1f},{y:.1f}" for x, y in at), COLORS[name]))
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{COLORS[name]}"/>' for x, y in at]
        out.append(f'<text x="{at[-1][0] + 8:.1f}" y="{at[-1][1] + 4:.1f}" fill="{COLORS[name]}">{name}</text>')
    out.append(f'<text x="{(LEFT + RIGHT) / 2}" y="{BOTTOM + 42}" text-anchor="middle">length of the cascade; {label}'
               '</text>')
    return "\n".join([*out, "</svg>", ""])


def write_plot(path, text):
    """The file appears whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".part")
    beside.write_text(text)
    beside.replace(path)


def write_plots(options, all_found):
    for name, title, label, pick in (("cascade_times", "Time of U2", "seconds", seconds),
                                     ("cascade_bits", "The largest exact number", "bits", bits)):
        series = {kernel: [(length, pick(found[kernel])) for length, found in all_found.items()
                           if found[kernel] and pick(found[kernel]) > 0] for kernel in KERNELS}
        if any(series.values()):
            write_plot(options.pictures / f"{name}.svg", plot(title, label, series))


def arguments():
    parser = argparse.ArgumentParser(description="time and bits by the length of a cascade")
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("generator", type=pathlib.Path)
    parser.add_argument("pictures", type=pathlib.Path)
    parser.add_argument("--limit", type=float, default=600, help="seconds of a run (600)")
    parser.add_argument("--longest", type=int, default=LENGTHS[-1], help="the longest cascade (10,000)")
    return parser.parse_args()


def main():
    options = arguments()
    options.program, options.generator = options.program.resolve(), options.generator.resolve()
    with tempfile.TemporaryDirectory() as scratch:
        try:
            all_found = {length: measured(options, length, pathlib.Path(scratch))
                         for length in LENGTHS if length <= options.longest}
        except Failure as failure:
            print("error:", failure, file=sys.stderr)
            return 1
    titles = ["length", "points", "n_WCC", *KERNELS]
    print_table("Time of U2 in milliseconds", titles, rows_of(all_found, lambda it: 1e3 * seconds(it), "{:,.3f}"), 0)
    print_table("The same as multiples of the Delaunay triangulation's time", titles,
                rows_of(all_found, lambda it: it["ratio_to_delaunay"]["u2"], "{:,.2f}"), 0)
    print_table("Bits of the largest exact number that was needed; 0: none", titles,
                rows_of(all_found, bits, "{:,}"), 0)
    print_table("Peak memory in MB", titles, rows_of(all_found, lambda it: it["peak_memory_bytes"] / 1e6, "{:,.1f}"), 0)
    write_plots(options, all_found)
    print(f"\nthe plots: {options.pictures}/cascade_times.svg, cascade_bits.svg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
