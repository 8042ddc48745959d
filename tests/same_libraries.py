#!/usr/bin/env python3
"""Whether flowcert writes the same with libc++ as with libstdc++: ./dev libcxx builds both, and calls this.

usage: same_libraries.py LIBSTDCXX LIBCXX [--jobs N]
       same_libraries.py --self-test

Both are build folders. Runs the commands of same_runs.py that such a folder has, and compares what same_outputs.py
compares: all bytes but the header, times and tallies of filters. The inputs are of the conformance vectors; there are
also numbers that are hard to read, and texts that are none.
Exit status: 0 where all is the same; 1 where something is not, or a program ends by a signal; 2 where fewer than 100
inputs of the vectors were compared in all parts.
"""
import argparse
import json
import os
import pathlib
import random
import sys
import tempfile
from fractions import Fraction

import same_runs
from same_outputs import compared_runs
from same_runs import Run

LEAST = 100  # inputs
EVERY = 12   # of the vectors' cases, this many have one that is taken
WHOLE = 4    # of these, this many have one that every command is run on

PARTS = (
    ("compute", "-", "--manifolds", "all", "--volumes", "exact", "--polylines", "--skeletons", "--sheets",
     "-o", "records.jsonl", "--certificate", "cells.fcert"),
    ("persistence", "-", "--zero", "-o", "pairs.pers"),
)
NUMBERS = (
    "1e999 -1e999 1e-999 -1e-999 1e309 1e308 -1e308 1.7976931348623157e308 1.7976931348623158e308 "
    "1.7976931348623159e308 4e-324 2e-324 2.4703282292062327e-324 2.4703282292062328e-324 1e99999999999 "
    "0e99999999999 1e-99999999999 nan -nan nan(1) inf -inf infinity +1 +-1 --1 1e 1e+ e5 . .5 5. 5.e1 0x1p3 0x1p-1074 "
    "0x1p-1075 0x1p1024 0x1.00000000000001 0x 1_0 1d5 1f 1e5x").split() + [
        "0." + "0" * 70000 + "1e70001", "1" + "0" * 70000 + "e-70000", "1" + "0" * 400, "0." + "0" * 400 + "1"]


def hard_rows(count):
    """Rows of three decimals: halfway between two doubles, with one digit more, and digits and exponent at random."""
    rng = random.Random(7)
    for _ in range(count):
        unit = Fraction(2) ** rng.randrange(-1074, 400)
        halfway = (rng.getrandbits(52 + rng.randrange(2)) + Fraction(1, 2)) * unit
        places = halfway.denominator.bit_length() - 1
        digits = halfway * 10 ** places
        yield (f"{digits}e-{places} {digits * 10 + rng.randrange(-1, 2)}e-{places + 1} "
               f"{rng.getrandbits(70)}e{rng.randrange(-340, 280)}\n")


def runs_on_numbers():
    rows = "".join(hard_rows(1000)).encode()
    yield Run("hard decimals", "flowcert", ("points", "-", "-o", "points.f64"), rows)
    for text in NUMBERS:
        yield Run(text[:20], "flowcert", ("points", "-", "-o", "points.f64"), f"0 0 {text}\n1 2 3\n".encode())


def cases_in(name):
    return json.loads((same_runs.ROOT / "spec" / "vectors" / name).read_text())["cases"]


def runs_on_other_vectors():
    for case in cases_in("invalid-input.json"):
        if "points" in case:
            yield Run(case["id"], "flowcert", ("compute", "-", "--json"), same_runs.point_file(case["points"]))
    cage = (("cage.xyz", (same_runs.ROOT / "tests" / "inputs" / "cage.xyz").read_bytes()),)
    yield Run("cage.xyz", "flowcert", ("pores", "cage.xyz", "--radii", "bondi", "--json"), b"", cage)
    words = ("pores", "-", "--radii", "column:4", "--depth", "0", "--json", "--windows-csv", "windows.csv")
    for case in cases_in("balls/pores.json"):
        yield Run(case["id"], "flowcert", words, same_runs.point_file(case["balls"]))


def runs_on_vectors(cases, names):
    for name in names:
        points = same_runs.point_file(cases[name]["points"])
        yield from (run for run in same_runs.runs_on(name, "-", True, points) if run.words[0] != "view")


def inputs_compared(folders, cases, names, jobs):
    """Complaints about all parts of these inputs, and how many inputs no program refuses."""
    complaints, left = [], len(names)
    for words in PARTS:
        runs = [Run(name, "flowcert", words, same_runs.point_file(cases[name]["points"])) for name in names]
        said, _, refused = compared_runs(folders, runs, jobs)
        complaints += said
        left = min(left, len(runs) - refused)
    return complaints, left


def exit_status(complaints, inputs):
    return 2 if inputs < LEAST else 1 if complaints else 0


def main():
    parser = argparse.ArgumentParser(description="whether libc++ and libstdc++ give the same answers")
    parser.add_argument("folders", nargs=2, type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    options = parser.parse_args()
    folders = [folder.resolve() for folder in options.folders]
    cases = same_runs.vector_cases()
    names = sorted(cases)[::EVERY]
    complaints, inputs = inputs_compared(folders, cases, names, options.jobs)
    others = [*runs_on_vectors(cases, names[::WHOLE]), *runs_on_numbers(), *runs_on_other_vectors(),
              *(run for run in same_runs.runs_on_files_of_others() if run.program == "flowcert")]
    said, useless, refused = compared_runs(folders, others, options.jobs)
    complaints += said + useless
    for complaint in complaints:
        print(complaint)
    print(f"all parts of {inputs} inputs, and {len(others)} other commands, of which {refused} refuse the input: "
          f"{len(complaints)} complaints")
    if inputs < LEAST:
        print(f"error: {LEAST} inputs should be compared", file=sys.stderr)
    return exit_status(complaints, inputs)


def self_test():
    points = {"points": [["0", "0", "0"]]}
    with tempfile.TemporaryDirectory() as scratch:
        folders = [pathlib.Path(scratch) / name for name in ("libstdcxx", "libcxx")]

        def result(body, names):
            for folder, text in zip(folders, ("cat >$0.seen; echo 1 >records.jsonl", body)):
                folder.mkdir(exist_ok=True)
                (folder / "flowcert").write_text(f"#!/bin/sh\n{text}\n")
                (folder / "flowcert").chmod(0o755)
            return inputs_compared(folders, dict.fromkeys(names, points), names, 1)

        assert result("echo 1 >records.jsonl", "ab") == ([], 2)
        complaints, inputs = result("[ $1 = compute ] && echo 2 >records.jsonl || echo 1 >records.jsonl", "a")
        assert inputs == 1 and len(complaints) == 1 and complaints[0].endswith(": records.jsonl differ")
        assert (folders[0] / "flowcert.seen").read_text() == "0 0 0\n"
    assert [exit_status(*of) for of in (([], LEAST), (["one"], LEAST), ([], LEAST - 1))] == [0, 1, 2]
    print("finds records that differ, and too few inputs")
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
