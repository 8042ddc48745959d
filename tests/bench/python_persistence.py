#!/usr/bin/env python3
"""FlowComplex(points).persistence() in Python against the program's own seconds for the same pairs.

usage: python_persistence.py PROGRAM SCAN [RUNS]      (with PYTHONPATH=build/python)

Program and package take turns, so that a busy machine slows down both. The program's time is the sum of `seconds` in
`persistence --json` without that of U2, which only this object tells of: it reads no file and writes nothing in that
time. Python's is all from the array of points to the
list of tuples, and giving up the complex. The last line has both medians and their ratio. Exit status 1 if Python takes
more than 10 % longer, or if the pairs differ.
"""
import json
import math
import statistics
import subprocess
import sys
import time

import flowcert

MOST = 1.10


def program_run(program, scan):
    """(seconds, pairs)"""
    words = [program, "persistence", scan, "--json"]
    answer = json.loads(subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout)
    value = lambda end: end["squared_distance_double"] if end else math.inf
    pairs = [(pair["dimension"], (value(pair["birth"]), value(pair["death"]))) for pair in answer["pairs"]]
    return sum(seconds for part, seconds in answer["seconds"].items() if part != "u2"), pairs


def python_run(points):
    start = time.perf_counter()
    pairs = flowcert.FlowComplex(points).persistence()
    return time.perf_counter() - start, pairs


def main(program, scan, runs="5"):
    points = flowcert.read_points(scan)
    seconds = {"program": [], "python": []}
    for _ in range(int(runs)):
        program_seconds, expected = program_run(program, scan)
        python_seconds, pairs = python_run(points)
        if pairs != expected:
            print("the pairs differ")
            return 1
        seconds["program"].append(program_seconds)
        seconds["python"].append(python_seconds)
        print(f"program {program_seconds * 1000:7.1f} ms   Python {python_seconds * 1000:7.1f} ms")
    medians = {name: statistics.median(values) for name, values in seconds.items()}
    ratio = medians["python"] / medians["program"]
    print(
        f"{len(points):,} points, {len(pairs):,} pairs, medians of {runs}: program {medians['program'] * 1000:.1f} ms, "
        f"Python {medians['python'] * 1000:.1f} ms, ratio {ratio:.3f} (at most {MOST:.2f})"
    )
    return 0 if ratio <= MOST else 1


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
