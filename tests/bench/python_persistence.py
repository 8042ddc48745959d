#!/usr/bin/env python3
"""FlowComplex(points).persistence() in Python against the program's own times for the same pairs.

usage: python_persistence.py PROGRAM SCAN [RUNS]      (with PYTHONPATH=build/python)

Program and package take turns, so that a busy machine slows down both. The program's time is that of the triangulation
and of all after it, in the table of `persistence`: it reads no file and writes nothing in that time. Python's is all
from the array of points to the list of tuples, and giving up the complex. The last line has both medians and their
ratio. Exit status 1 if Python takes more than 10 % longer, or if the pairs differ.
"""
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import flowcert

MOST = 1.10
ROW = re.compile(r"^(?:Delaunay triangulation|all after the triangulation) +([0-9.]+) (ms|s)\b", re.MULTILINE)


def program_run(program, scan):
    """(seconds, pairs)"""
    with tempfile.NamedTemporaryFile(mode="r", suffix=".pers") as file:
        words = [program, "persistence", scan, "-o", file.name]
        table = subprocess.run(words, stdout=subprocess.PIPE, check=True, text=True).stdout
        rows = [line.split() for line in Path(file.name).read_text().splitlines() if not line.startswith("#")]
    pairs = [(int(dimension), (float(birth), float(death))) for dimension, birth, death in rows]
    return sum(float(number) * (0.001 if unit == "ms" else 1) for number, unit in ROW.findall(table)), pairs


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
