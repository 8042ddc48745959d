#!/usr/bin/env python3
"""The proved checker of certificates and flowcert-proof say the same: same_verdicts.py FLOWCERT PROOF BUILD.

The checker is built in BUILD/proofs/, which needs Coq and OCaml.
Makes certificates of small inputs of dimension -1 to 3, random, cospherical, or with repeated points. They are right,
or have bytes flipped, cut off or added, cells left out or exchanged, or points moved.
Compares the exit status, the counts of stationary points where all is proved, and the condition where one fails; of
right certificates also each kind and contact set with the list of FLOWCERT. Exit status 1 where something differs.
The test proofs/checker makes 1,000. By hand, --count 10000 makes ten times as many, and --seed N makes others.
"""
import argparse
import collections
import itertools
import json
import math
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "spec"))
import proof
from proved_program import built

CASES_A_BASE = 8


# ---- Points


def coordinates(rng):
    """A function that makes one coordinate."""
    size = rng.choice([2, 3, 5, 1000])
    return rng.choice([lambda: float(rng.randint(-size, size)), lambda: rng.uniform(-1, 1),
                       lambda: rng.uniform(-1, 1) * 2.0 ** rng.randint(-40, 40)])


def cospherical(rng):
    """Points of integers on one sphere."""
    radius = rng.choice([3, 9, 25, 50, 81])
    near = range(-math.isqrt(radius) - 1, math.isqrt(radius) + 2)
    on = [p for p in itertools.product(near, repeat=3) if sum(x * x for x in p) == radius]
    return [tuple(map(float, p)) for p in rng.sample(on, min(len(on), rng.randint(4, 14)))]


def points(rng):
    """4 to 30 rows as a rule, and few of them at times."""
    kind, one = rng.randrange(10), coordinates(rng)
    count = rng.randint(4, 30) if rng.random() < 0.5 else rng.randint(4, 12)
    rows = [(one(), one(), one()) for _ in range(count)]
    if kind == 0:
        rows = rows[:rng.randrange(4)]
    elif kind == 1:
        rows = [(2 * i, -i, 3 * i) for i in (float(rng.randint(-9, 9)) for _ in rows)]
    elif kind in (2, 3):
        rows = [(x, y, x + y) for x, y in (map(lambda v: float(rng.randint(-4, 4)), p[:2]) for p in rows)]
    elif kind in (4, 5):
        rows = cospherical(rng)
    elif kind == 6:
        rows = [(p[0], p[1], 0.0) for p in cospherical(rng)]
    for _ in range(rng.choice([0, 0, 1, 3]) if rows else 0):
        rows.insert(rng.randrange(len(rows) + 1), rng.choice(rows))
    return rows


def write_points(path, rows):
    if path.suffix == ".f64":
        path.write_bytes(b"".join(struct.pack("<3d", *row) for row in rows))
    else:
        path.write_text("".join("{!r} {!r} {!r}\n".format(*row) for row in rows))


# ---- Certificates that are wrong


def flip_bytes(rng, data, times):
    head = data.index(b"\n\n") + 2
    body = bytearray(data[head:])
    for _ in range(times if body else 0):
        body[rng.randrange(len(body))] = rng.choice([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 129, rng.randrange(256)])
    return data[:head] + bytes(body)


def change_length(rng, data):
    end = data.index(b"\n\n") + 2
    cut = rng.randint(end, len(data)) if rng.random() < 0.8 else rng.randrange(len(data))
    return data[:cut] if rng.random() < 0.6 else data + bytes(rng.randrange(256) for _ in range(rng.randint(1, 3)))


def change_header(rng, data):
    key = rng.choice([b"cells", b"dimension", b"points"])
    return re.sub(key + rb" (-?\d+)", lambda m: key + b" %d" % (int(m[1]) + rng.choice([-1, 1])), data, count=1)


def flipped(rng, cells):
    """Two cells at a facet replaced: one edge by the other, or two tetrahedra by three."""
    one = rng.choice(cells)
    others = [c for c in cells if len(set(c) & set(one)) == len(one) - 1]
    if not others or len(one) < 3:
        return cells
    two = rng.choice(others)
    facet = sorted(set(one) & set(two))
    a, b = (set(one) | set(two)) - set(facet)
    new = [(*(p for p in facet if p != left), a, b) for left in facet]
    return [c for c in cells if c not in (one, two)] + new


def change_cells(rng, cells):
    how = rng.randrange(5)
    if how == 0:
        cells = rng.sample(cells, max(1, len(cells) - rng.randint(1, 3)))
    elif how in (1, 2):
        for _ in range(rng.randint(1, 3)):
            cells = flipped(rng, cells)
    elif how == 3:
        gone = rng.choice(rng.choice(cells))
        cells = [c for c in cells if gone not in c] or cells
    else:
        cells = [tuple(p if rng.random() < 0.97 else rng.choice(rng.choice(cells)) for p in c) for c in cells]
    return cells


def encoded(path, dimension, cells, instead=b""):
    """A certificate of any cells, with positive volumes where they have one; or what is to be there instead."""
    made = proof.Triangulation(proof.Points(str(path)), dimension, "")
    volumes = [1] * len(cells)
    try:
        made.check_dimension(cells)
        volumes = [made.volume(made.edges(c)) for c in cells]
    except proof.Rejected:
        pass
    made.cells = [c if v >= 0 else (c[1], c[0], *c[2:]) for c, v in zip(cells, volumes)]
    try:
        return proof.encode(made)
    except proof.Rejected:  # three cells at a facet cannot be written
        return instead


# ---- One input and its certificates


class Cases:
    def __init__(self, folder, flowcert):
        self.folder, self.flowcert, self.pairs, self.lists = folder, flowcert, [], {}

    def add(self, points_path, data):
        path = self.folder / f"{len(self.pairs)}.fcert"
        path.write_bytes(data)
        self.pairs.append((points_path, path))

    def moved(self, rng, number, rows):
        rows = [list(row) for row in rows]
        for _ in range(rng.randint(1, 2) if rows else 0):
            row = rng.choice(rows)
            if rng.random() < 0.3:
                other = rng.choice(rows)
                row[:], other[:] = other[:], row[:]
            else:
                row[rng.randrange(3)] += rng.choice([1, -1, 3, 1e-3, -1e-9])
        path = self.folder / f"{number}m.f64"
        write_points(path, rows)
        return path

    def pentagon(self, rng, number):
        """Around a point, in one plane; every second corner is a cell's."""
        count = rng.choice([5, 7, 9])
        turns = [2 * math.pi * (i + rng.uniform(-0.1, 0.1)) / count for i in range(count)]
        ring = [(round(100 * math.cos(t)), round(100 * math.sin(t)), 0) for t in turns]
        path = self.folder / f"{number}p.xyz"
        write_points(path, [(0, 0, 0), *ring])
        names = range(1, count + 1)
        cells = [(0, names[i], names[(i + 2) % count]) for i in range(count)]
        self.add(path, encoded(path, 2, cells))

    def make(self, rng, number):
        rows = points(rng)
        text = self.folder / f"{number}.xyz"
        raw = self.folder / f"{number}.f64"
        write_points(text, rows)
        write_points(raw, rows)
        right, list_path = self.folder / f"{number}.right", self.folder / f"{number}.jsonl"
        source = text if rows else raw
        if rows:
            subprocess.run([self.flowcert, "compute", text, "-o", list_path, "--certificate", right], check=True,
                           capture_output=True)
            data = right.read_bytes()
            self.lists[len(self.pairs)] = list_path
        else:
            data = b"flowcert-certificate 1\npoints 0\ndimension -1\ncells 0\n\n"
        self.add(rng.choice([source, raw]), data)
        self.add(source, flip_bytes(rng, data, 1))
        self.add(source, flip_bytes(rng, data, rng.randint(1, 4)))
        self.add(raw, change_length(rng, data))
        self.add(source, change_header(rng, data))
        self.add(self.moved(rng, number, rows), data)
        triangulation, _ = proof.read_certificate(str(right), proof.Points(str(text))) if rows else (None, None)
        if not triangulation or not triangulation.cells:
            self.pentagon(rng, number)
            self.add(raw, change_header(rng, flip_bytes(rng, data, 2)))
            return
        cells = triangulation.cells
        others = rng.sample(cells, len(cells))
        self.add(source, encoded(text, triangulation.dimension, others))
        changed = change_cells(rng, others)
        self.add(source, encoded(text, triangulation.dimension, changed, flip_bytes(rng, data, 2)))


# ---- Verdicts

KINDS = ["0", "1", "2", "3", "[1, 2]", "[1, 3]", "[2, 3]"]


def verdict_of_proof(program, pair):
    ran = subprocess.run([program, *pair], capture_output=True, text=True)
    return ran.returncode, summary(ran.returncode, ran.stdout.replace("\n", "; "))


def summary(status, text):
    """The counts, or the condition."""
    found = re.search(r"all \d+ stationary points: .*?2-3: \d+" if status == 0 else r"T[0-8]", text)
    return found[0] if found else ""


def list_of(path):
    lines = map(json.loads, path.read_text().splitlines()[1:])
    return sorted((KINDS.index(str(line["index"])), *line["contact"]) for line in lines)


def compare(cases, checker, program):
    names = "".join(f"{points} {certificate}\n" for points, certificate in cases.pairs)
    ran = subprocess.run([checker, "--batch"], input=names, capture_output=True, text=True, check=True)
    seen, wrong = collections.Counter(), []
    for number, (pair, line) in enumerate(zip(cases.pairs, ran.stdout.splitlines(), strict=True)):
        status = int(line[0])
        found = (status, summary(status, line))
        expected = verdict_of_proof(program, pair)
        seen[expected[1] if expected[0] == 1 else ("proved", "", "undecodable")[expected[0]]] += 1
        if found != expected:
            wrong.append(f"{pair[0].name} {pair[1].name}: {found} and not {expected}")
        if number in cases.lists and status == 0:
            told = sorted(tuple(map(int, part.split())) for part in line.split("; ")[2:])
            if told != list_of(cases.lists[number]):
                wrong.append(f"{pair[0].name} {pair[1].name}: another list")
    return seen, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("flowcert")
    parser.add_argument("proof")
    parser.add_argument("build")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", help="a folder for the inputs")
    options = parser.parse_args()
    checker, rng = built("checker", options.build), random.Random(options.seed)
    with tempfile.TemporaryDirectory() as made:
        cases = Cases(pathlib.Path(options.keep or made), options.flowcert)
        for number in range(-(-options.count // CASES_A_BASE)):
            cases.make(rng, number)
        seen, wrong = compare(cases, checker, options.proof)
    print(f"{len(cases.pairs)} certificates: " + ", ".join(f"{key} {count}" for key, count in sorted(seen.items())))
    print("\n".join(wrong[:20] + [f"{len(wrong)} verdicts differ"] if wrong else ["all verdicts are the same"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
