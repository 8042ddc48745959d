#!/usr/bin/env python3
"""Guards speed: instructions and last-level cache misses of FLOWCERT, as callgrind counts them on a simulated cache.

usage: guard.py FLOWCERT [--accept]
       guard.py --take TABLE

Six inputs of at most 10,000 points, the same everywhere, each by two commands, in one thread. The table guard.json has
a row of figures for each compiler and version of CGAL that was accepted. Clocks and other programs change nothing: two
runs differ by less than 0.1 %. Exit status: 0; 1 where instructions grew by more than 3 %, or misses by more than 5 %;
2 where there is no row yet. --accept writes the row, with the figures of this run, and --take takes over the
rows of another table.
"""
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TABLE = Path(__file__).with_name("guard.json")
MOST = {"instructions": 1.03, "misses": 1.05}
CACHES = ("--I1=32768,8,64", "--D1=32768,8,64", "--LL=8388608,16,64")
COMMANDS = {
    "compute": lambda scan, folder: ["compute", scan, "--manifolds", "s2,u2", "-o", folder / "list.jsonl"],
    "persistence": lambda scan, folder: ["persistence", scan, "-o", folder / "pairs.pers"],
}


def uniform(count, seed):
    draw = random.Random(seed).random
    return [(draw(), draw(), draw()) for _ in range(count)]


def on_surface(count, seed, places):
    """A torus that is bent, as a scan has it: coordinates rounded to so many decimal places."""
    draw = random.Random(seed).random
    rows = []
    for _ in range(count):
        u, v = 2 * math.pi * draw(), 2 * math.pi * draw()
        ring = 1 + 0.35 * math.cos(v)
        row = (ring * math.cos(u), ring * math.sin(u), 0.35 * math.sin(v) + 0.2 * math.cos(3 * u))
        rows.append(tuple(round(x, places) for x in row))
    return rows


def packed(count, seed):
    """Points with a least distance, as atoms have it."""
    draw = random.Random(seed).random
    cells, rows, width = {}, [], 20.0
    while len(rows) < count:
        row = tuple(round(width * draw(), 3) for _ in range(3))
        at = tuple(int(x) for x in row)
        near = [(at[0] + i, at[1] + j, at[2] + k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
        if all(math.dist(row, cells[key]) >= 1 for key in near if key in cells) and at not in cells:
            cells[at] = row
            rows.append(row)
    return rows


INPUTS = {
    "uniform": lambda: uniform(10000, 1),
    "scan": lambda: on_surface(10000, 2, 12),
    "rounded scan": lambda: on_surface(10000, 3, 3),
    "lattice": lambda: [(x, y, z) for x in range(16) for y in range(16) for z in range(16)],
    "atoms": lambda: packed(3000, 4),
    "plane": lambda: [(x, y, 0.0) for x, y, _ in uniform(10000, 5)],
}


def counted(words, folder):
    """Instructions and last-level misses."""
    out = folder / "callgrind.out"
    command = ["valgrind", "--tool=callgrind", "--cache-sim=yes", *CACHES, f"--callgrind-out-file={out}", *words]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(str(word) for word in words)}: exit status {done.returncode}\n{done.stderr}")
    text = out.read_text()
    events = re.search(r"^events: (.*)$", text, re.MULTILINE)[1].split()
    totals = dict(zip(events, map(int, re.search(r"^(?:summary|totals): (.*)$", text, re.MULTILINE)[1].split())))
    return {"instructions": totals["Ir"], "misses": totals["ILmr"] + totals["DLmr"] + totals["DLmw"]}


def write(table):
    TABLE.write_text(json.dumps(dict(sorted(table.items())), indent=1) + "\n")


def main(flowcert, accept):
    table = json.loads(TABLE.read_text())
    figures, grown = {}, []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for scan, make in INPUTS.items():
            path = folder / "scan.xyz"
            path.write_text("".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in make()))
            for command, words in COMMANDS.items():
                figures[f"{scan}, {command}"] = counted([flowcert, *words(path, folder), "--threads", 1], folder)
        header = json.loads(subprocess.run([flowcert, "persistence", path, "--json"], stdout=subprocess.PIPE,
                                           check=True).stdout)
    row = f"{header['compiler']}, CGAL {header['cgal']}"
    before = table.get(row, {})
    print(f"{row}\n{'':24}{'instructions':>16}{'':9}{'misses':>12}")
    for key, counts in figures.items():
        line = f"{key:24}"
        for event, count in counts.items():
            ratio = count / before[key][event] if key in before else None
            line += f"{count:>{16 if event == 'instructions' else 12},}{f'{ratio:8.3f}x' if ratio else '':9}"
            if ratio and ratio > MOST[event]:
                grown.append(f"{key}: {event} grew to {ratio:.3f} times")
        print(line.rstrip())
    if accept:
        write({**table, row: figures})
        return 0
    print("\n".join(grown))
    if not before:
        print(f"there is no row of {row} yet; --accept writes it")
    return 1 if grown else 0 if before else 2


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--take":
        write({**json.loads(TABLE.read_text()), **json.loads(Path(sys.argv[2]).read_text())})
        sys.exit(0)
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--accept"]):
        raise SystemExit(__doc__)
    os.environ["LC_ALL"] = "C"
    sys.exit(main(sys.argv[1], len(sys.argv) == 3))
