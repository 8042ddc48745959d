#!/usr/bin/env python3
"""The paper's Tables 2 to 5 and Figures 10 to 12 for scans, by all three kernels, beside what the paper published.

usage: paper_tables.py PROGRAM PICTURES [--alone] [--limit SECONDS] [--data FOLDER] [SCAN ...]
       paper_tables.py --self-test

PICTURES is a folder for the histograms as SVG files. FOLDER's .xyz, .ply and .off files are scans, too; kitten.xyz is
taken from Debian's libcgal-demo if it is not among them. Each kernel computes S2 and U2 by runs of their own, in one
thread; the cascade kernel's times are medians of five. A run over the limit, 600 seconds, is an x, and so are the
exact kernel beyond 10,000 points and the lazy one beyond 100,250. Times are ratios to CGAL's Delaunay triangulation in
the same run.
Guarantees: Table 3 and Figures 10 and 11 are the same for each kernel that ends.
Exit status: 0; 1 where two kernels disagree, or a program ends otherwise than by the limit; 2 for bad usage.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tarfile
import tempfile

import published_figures as published

KERNELS = ("cascade", "lazy", "exact")
MOST_POINTS = {"cascade": None, "lazy": 100250, "exact": 10000}
TAGS = ("S2", "U2")
PAPER = "(paper)"
ARCHIVE = pathlib.Path("/usr/share/doc/libcgal-dev/data.tar.gz")
LENGTHS = (("S2", "S2", "n_s2"), ("U2", "U2", "n_u2"), ("WCC", "U2", "n_wcc"))


class Failure(Exception):
    """A run that ends neither well nor by the limit of time."""


def run(command, limit):
    """Standard output, or None where the limit of time is over."""
    try:
        done = subprocess.run(command, capture_output=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}: exit status {done.returncode}, {done.stderr.decode().strip()}")
    return done.stdout.decode()


def is_too_large(kernel, points):
    return MOST_POINTS[kernel] is not None and points > MOST_POINTS[kernel]


def measured(options, name, scan):
    """What `stats` says of a scan, by kernel and tag; None for an x."""
    found = {}
    points = None
    for kernel in KERNELS:
        for tag in TAGS:
            if points is not None and is_too_large(kernel, points):
                found[kernel, tag] = None
                continue
            command = [options.program, "stats", scan, "--json", "--kernel", kernel, "--manifolds", tag.lower(),
                       "--threads", "1", "--svg", options.pictures / f"{name}-{kernel}"]
            command += ["--alone"] if options.alone else []
            command += ["--runs", "5"] if kernel == "cascade" else []
            text = run(command, options.limit)
            found[kernel, tag] = None if text is None else json.loads(text)
            if text is not None:
                points = found[kernel, tag]["points"]
            print(f"  {name}, {tag}, {kernel}: {'x' if text is None else 'done'}", file=sys.stderr, flush=True)
    return found


def statistics(found, key, tag):
    """A distribution, which must be the same for all kernels that have it; None where none has."""
    all_of_them = [found[kernel, tag][tag.lower()][key] for kernel in KERNELS if found[kernel, tag]]
    if any(one != all_of_them[0] for one in all_of_them):
        raise Failure(f"the kernels disagree about {key}")
    return all_of_them[0] if all_of_them else None


# ---- Printing ----

def cell(value, form="{:,}"):
    return "x" if value is None else value if isinstance(value, str) else form.format(value)


def table_lines(titles, rows, left=1):
    """Columns as wide as their widest cells; so many of them, from the first, to the left."""
    rows = [list(titles), *[[cell(value) for value in row] for row in rows]]
    widths = [max(len(row[k]) for row in rows) for k in range(len(titles))]
    return ["  ".join(text.ljust(width) if k < left else text.rjust(width)
                      for k, (text, width) in enumerate(zip(row, widths))).rstrip() for row in rows]


def print_table(title, titles, rows, left=1):
    print(f"\n{title}\n")
    print("\n".join(table_lines(titles, rows, left)), flush=True)


def per_kernel(found, tag, pick, form):
    return [cell(pick(found[kernel, tag]) if found[kernel, tag] else None, form) for kernel in KERNELS]


def print_table_2(all_found):
    titles = ["model", "tag", "points", "idx_1", "idx_2", "idx_3", "Euler", "t_D [s]", *KERNELS,
              *[f"MB {kernel}" for kernel in KERNELS]]
    rows = []
    for name, found in all_found.items():
        for tag in TAGS:
            one = next((found[kernel, tag] for kernel in KERNELS if found[kernel, tag]), None)
            if one is None:
                continue
            rows.append([name, tag, one["points"], *one["critical"][1:], one["euler"],
                         cell(one["seconds"]["delaunay"], "{:.3f}"),
                         *per_kernel(found, tag, lambda it: it["ratio_to_delaunay"]["all"], "{:.2f}"),
                         *per_kernel(found, tag, lambda it: it["peak_memory_bytes"] / 1e6, "{:.1f}")])
    for name, tag, points, counts, euler, seconds, ratio, memory in published.TABLE_2:
        rows.append([f"{name} {PAPER}", tag, points, *counts[1:], euler, f"{seconds:.2f}", "", f"{ratio:.2f}", "", "",
                     f"{memory:.2f}", ""])
    print_table("Table 2: times as multiples of the Delaunay triangulation's, and memory, by kernel", titles, rows, 2)


def print_table_3(all_found):
    rows = []
    for name, found in all_found.items():
        for label, tag, key in LENGTHS:
            one = statistics(found, key, tag)
            if one is not None:
                rows.append([name, label, f"{one['mean']:.2f}", one["max"], f"{one['stddev']:.2f}", one["mode"],
                             f"{one['median']:g}"])
    for name, label, mean, most, deviation, mode, median in published.TABLE_3:
        rows.append([f"{name} {PAPER}", label, f"{mean:.2f}", most, f"{deviation:.2f}", mode, f"{median:g}"])
    print_table("Table 3: lengths; the kernels agree", ["model", "tag", "mean", "max", "stddev", "mode", "median"],
                rows, 2)


def counts_of(result, tag, names):
    """Failures and calls of some primitives together, or an x."""
    if result is None:
        return "x"
    every = {**result["filters"], **result[tag.lower()]["primitives"]}
    return f"{sum(every[name]['failures'] for name in names)}/{sum(every[name]['calls'] for name in names)}"


def print_table_4(all_found):
    rows = []
    for operation, s2, u2, ours, instead in published.TABLE_4:
        pairs = ["-" if pair is None else f"{pair[0]}/{pair[1]}" for pair in (s2, u2)]
        rows.append([operation, *pairs, " + ".join(ours) or f"none: {instead}"])
    print_table("Table 4: filter failures/calls of the paper's operations on Mecanic, and our primitives for them",
                ["operation", f"S2 {PAPER}", f"U2 {PAPER}", "ours"], rows)
    for name, found in all_found.items():
        rows = [[operation, *[counts_of(found[kernel, tag], tag, ours) for kernel in KERNELS for tag in TAGS]]
                for operation, _, _, ours, _ in published.TABLE_4 if ours]
        print_table(f"Table 4: failures/calls of our primitives, {name}",
                    ["operation", *[f"{tag} {kernel}" for kernel in KERNELS for tag in TAGS]], rows)


def print_table_5(all_found):
    rows = [[name, *[cell(found[kernel, tag] and found[kernel, tag][tag.lower()]["depth"])
                     for kernel in KERNELS for tag in TAGS]] for name, found in all_found.items()]
    rows += [[f"{name} {PAPER}", "", "", s2, u2, "", ""] for name, s2, u2 in published.TABLE_5]
    print_table("Table 5: deepest construction; our lazy kernel cuts chains at 1,000",
                ["model", *[f"{tag} {kernel}" for kernel in KERNELS for tag in TAGS]], rows)


def doubling(histogram):
    """The counts of sizes, by the greatest power of two that a size reaches."""
    bins = {}
    for value, count in histogram:
        start = 1 << (value.bit_length() - 1) if value else 0
        bins[start] = bins.get(start, 0) + count
    return bins


def print_figures(options, scans, all_found):
    for name, found in all_found.items():
        print(f"\nFigures 10, 11: {name}")
        text = run([options.program, "stats", scans[name]], options.limit)
        print("  x" if text is None else text.split("\nSizes of the exact numbers")[0], flush=True)
        sizes = [doubling(found[kernel, "U2"]["u2"]["exact_bytes"]["histogram"]) if found[kernel, "U2"] else None
                 for kernel in KERNELS]
        rows = [[start, *[None if bins is None else bins.get(start, 0) for bins in sizes]]
                for start in sorted(set().union(*[bins for bins in sizes if bins]))]
        print_table(f"Figure 12: sizes of exact numbers in bytes, {name}", ["from", *KERNELS], rows, 0)


# ---- The whole ----

def kitten(folder):
    """kitten.xyz of Debian's archive, written into the folder."""
    if not ARCHIVE.is_file():
        return []
    with tarfile.open(ARCHIVE) as archive:
        try:
            file = archive.extractfile("data/points_3/kitten.xyz")
        except KeyError:
            return []
        (folder / "kitten.xyz").write_bytes(file.read())
    return [folder / "kitten.xyz"]


def scans_of(options, scratch):
    """Each scan, by its name; the first of one name is taken, and smaller files come first."""
    given = list(options.scans)
    if options.data:
        given += sorted(path for path in options.data.iterdir() if path.suffix in (".xyz", ".ply", ".off"))
    scans = {}
    for path in [*given, *kitten(scratch)]:
        scans.setdefault(path.stem, path.resolve())
    return dict(sorted(scans.items(), key=lambda item: item[1].stat().st_size))


def arguments():
    parser = argparse.ArgumentParser(description="the paper's tables and figures for scans")
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("pictures", type=pathlib.Path)
    parser.add_argument("scans", nargs="*", type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path)
    parser.add_argument("--alone", action="store_true", help="each orbit alone, as the paper computed them")
    parser.add_argument("--limit", type=float, default=600, help="seconds of a run (600)")
    return parser.parse_intermixed_args()


def main():
    options = arguments()
    options.program = options.program.resolve()
    with tempfile.TemporaryDirectory() as scratch:
        try:
            scans = scans_of(options, pathlib.Path(scratch))
        except OSError as error:
            print("error:", error, file=sys.stderr)
            return 2
        try:
            all_found = {name: measured(options, name, scan) for name, scan in scans.items()}
            for print_one in (print_table_2, print_table_3, print_table_4, print_table_5):
                print_one(all_found)
            print_figures(options, scans, all_found)
        except Failure as failure:
            print("error:", failure, file=sys.stderr)
            return 1
    print(f"\nthe histograms as pictures: {options.pictures}/")
    return 0


def self_test():
    assert table_lines(["a", "b"], [["word", 1234], ["x", None]]) == ["a         b", "word  1,234", "x         x"]
    assert doubling([[0, 1], [1, 2], [7, 3], [8, 4]]) == {0: 1, 1: 2, 4: 3, 8: 4}
    assert run(["sh", "-c", "echo 1"], 10) == "1\n"
    assert run(["sleep", "10"], 0.1) is None
    for status in ("exit 1", "kill -9 $$"):
        try:
            run(["sh", "-c", status], 10)
            raise AssertionError("a failure is not seen")
        except Failure:
            pass
    same = {(kernel, "U2"): {"u2": {"n_u2": {"max": 3}}} for kernel in KERNELS}
    assert statistics({**same, ("exact", "U2"): None}, "n_u2", "U2") == {"max": 3}
    try:
        statistics({**same, ("lazy", "U2"): {"u2": {"n_u2": {"max": 4}}}}, "n_u2", "U2")
        raise AssertionError("a disagreement is not seen")
    except Failure:
        pass
    assert not is_too_large("lazy", 100250) and is_too_large("exact", 10001) and not is_too_large("cascade", 10**9)
    result = {"filters": {"angle": {"calls": 5, "failures": 1}},
              "u2": {"primitives": {"crossing": {"calls": 7, "failures": 2}}}}
    assert counts_of(result, "U2", ("angle", "crossing")) == "3/12"
    assert all(sum(row[3]) - 2 * (row[3][1] + row[3][3]) == row[4] for row in published.TABLE_2)
    print("sees runs over the limit, failures and disagreements; the paper's counts have the paper's Euler sums")
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
