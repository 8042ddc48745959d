#!/usr/bin/env python3
"""Seconds and peak memory of `flowcert persistence` and of GUDHI's alpha complexes, whole programs, in one run.

usage: scaling.py PROGRAM DIRECTORY [--runs N] [SIZE|FILE]...

A SIZE is so many points, uniform in (-1,1)^3; a FILE is a scan in .obj or .xyz. Without any: 10^4, 10^5, 10^6 and
3 x 10^6 points. All programs read the same OFF file in DIRECTORY, use one thread, and write the pairs of positive
length to a file. They take turns. GUDHI's program for three dimensions, which is much like its other one, is left out
of large inputs. Seconds are processor time, medians of N runs (1). A program that fails gets an x,
as one does that asks for more than three quarters of the machine's memory. Standard output is Markdown, and each run
is told on standard error when it ends. Exit status 1 if flowcert fails, or has another number of pairs than GUDHI's
exact complex, but for such as have one double at both ends.
"""
import argparse
import os
import random
import resource
import statistics
import subprocess
import sys
from pathlib import Path

SIZES = ("10000", "100000", "1000000", "3000000")
OURS = "flowcert"
# GUDHI's program for points of any dimension, and the one for three.
PROGRAMS = {"GUDHI": "gudhi-alpha-complex-persistence", "GUDHI 3d": "gudhi-alpha-complex-3d-persistence"}
MOST_OF_3D = 200_000  # points
PRECISIONS = {"fast": ["-f"], "safe": [], "exact": ["-e"]}


def commands(program, points, count, directory):
    """By name: the words, and the file of pairs."""
    pairs = directory / "flowcert.pers"
    made = {OURS: ([program, "persistence", points, "-o", pairs, "--threads", "1"], pairs)}
    for name, command in PROGRAMS.items():
        if name == "GUDHI 3d" and count > MOST_OF_3D:
            continue
        for precision, options in PRECISIONS.items():
            pairs = directory / f"{name} {precision}.pers".replace(" ", "-")
            made[f"{name} {precision}"] = ([command, *options, "-p", "2", "-m", "0", "-o", pairs, points], pairs)
    return made


def uniform(size):
    random.seed(size)
    return [" ".join(repr(random.uniform(-1, 1)) for _ in range(3)) for _ in range(size)]


def of_scan(path):
    """Each point once."""
    rows = [line.split() for line in Path(path).read_text().splitlines()]
    if path.endswith(".obj"):
        rows = [words[1:] for words in rows if words[:1] == ["v"]]
    return list(dict.fromkeys(" ".join(words[:3]) for words in rows if len(words) >= 3))


def run(words):
    """(seconds, megabytes), or nothing if it fails."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") * 3 // 4
    child = subprocess.Popen(
        words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory)),
    )
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return (used.ru_utime + used.ru_stime, used.ru_maxrss / 1000) if child.returncode == 0 else None


def pair_count(path):
    """GUDHI's lines begin with the field's characteristic; all have one line a pair."""
    with open(path) as lines:
        return sum(not line.startswith("#") and line.strip() != "" for line in lines)


def short_pair_count(path):
    """Our pairs whose exact ends have one nearest double. GUDHI's values are doubles, so that it may lack them."""
    with open(path) as lines:
        return sum(not line.startswith("#") and line.split()[1] == line.split()[2] for line in lines if line.strip())


def measure(program, directory, name, runs):
    """A row for each program. Returns the rows, and what is wrong."""
    points = directory / "points.off"
    rows = uniform(int(name)) if name.isdigit() else of_scan(name)
    points.write_text(f"OFF\n{len(rows)} 0 0\n" + "\n".join(rows) + "\n")
    made = commands(program, points, len(rows), directory)
    found = {one: [] for one in made}
    for _ in range(runs):
        for one, (words, _) in made.items():
            if None not in found[one]:
                result = run(words)
                found[one].append(result)
                told = "failed" if result is None else f"{result[0]:.2f} s, {result[1]:.0f} MB"
                print(f"{name}: {one}: {told}", file=sys.stderr, flush=True)
    input_name = f"{len(rows):,} uniform" if name.isdigit() else Path(name).stem
    table, faults = [], []
    counts = {one: pair_count(pairs) for one, (_, pairs) in made.items() if None not in found[one]}
    if OURS not in counts:
        return [], [f"{input_name}: flowcert failed"]
    ours = statistics.median(seconds for seconds, _ in found[OURS])
    for one, results in found.items():
        if None in results:
            table.append([input_name, one, "x", "", "", ""])
            continue
        seconds = statistics.median(result[0] for result in results)
        memory = max(result[1] for result in results)
        table.append([input_name, one, f"{seconds:.2f}", f"{seconds / ours:.1f}", f"{memory:,.0f}", f"{counts[one]:,}"])
        most = counts[OURS]
        if one == "GUDHI exact" and not most - short_pair_count(made[OURS][1]) <= counts[one] <= most:
            faults.append(f"{input_name}: {one} has {counts[one]} pairs, flowcert {counts[OURS]}")
    return table, faults


def print_row(cells):
    print(f"| {' | '.join(cells)} |", flush=True)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("directory", type=Path)
    parser.add_argument("inputs", nargs="*", default=SIZES)
    parser.add_argument("--runs", type=int, default=1)
    chosen = parser.parse_intermixed_args(arguments)
    chosen.directory.mkdir(parents=True, exist_ok=True)
    print_row(["input", "program", "seconds", "times ours", "peak memory [MB]", "pairs"])
    print_row(["---", "---", "---:", "---:", "---:", "---:"])
    all_faults = []
    for name in chosen.inputs:
        table, faults = measure(chosen.program, chosen.directory, name, chosen.runs)
        all_faults += faults
        for row in table:
            print_row(row)
    for fault in all_faults:
        print(fault, file=sys.stderr)
    return 1 if all_faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
