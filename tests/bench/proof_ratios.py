#!/usr/bin/env python3
"""What a proof costs: flowcert-proof's processor time by that of CGAL's Delaunay triangulation, and of what it checks.

usage: proof_ratios.py FLOWCERT PROOF [SCAN ...]

The lattice 40 x 40 x 40 is added to the scans. All in one thread, medians of three rounds, each of which has its own
triangulation. Columns: the certificate alone and the pairs on top, by the triangulation's time; with the exact list, by
`compute -o`'s time; memory of these, by that of `compute -o`, and with pairs by that of `persistence`; bytes a cell.
Exit status: 0; 1 where a proof fails; 2 for bad usage.
"""
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROUNDS = 3
HEAD = ("scan", "check", "pairs", "list", "memory", "with list", "with pairs", "bytes")


def run(*command):
    """Standard output, seconds of processor time, and KiB of memory."""
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen([str(word) for word in command], stdout=out)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        if process.returncode != 0:
            raise SystemExit(f"{command[0]} {command[1]}: exit status {process.returncode}")
        return out.read(), usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def figures(flowcert, proof, scan, folder):
    points, cells, records, pairs = (folder / name for name in ("p.f64", "c.fcert", "list.jsonl", "pairs.pers"))
    run(flowcert, "points", scan, "-o", points)
    rounds = []
    for _ in range(ROUNDS):
        summary, compute, compute_memory = run(flowcert, "compute", scan, "--threads", 1, "-o", records, "--json")
        run(flowcert, "compute", scan, "--threads", 1, "--certificate", cells)
        _, _, pairs_memory = run(flowcert, "persistence", scan, "--threads", 1, "-o", pairs)
        delaunay = json.loads(summary)["seconds"]["delaunay"]
        _, check, memory = run(proof, points, cells)
        _, with_list, list_memory = run(proof, points, cells, records)
        _, with_pairs, proved_memory = run(proof, points, cells, "--pairs", pairs)
        count = int(cells.read_bytes().partition(b"\n\n")[0].split()[-1])
        rounds.append((check / delaunay, (with_pairs - check) / delaunay, with_list / compute, memory / compute_memory,
                       list_memory / compute_memory, proved_memory / pairs_memory, cells.stat().st_size / count))
    return [statistics.median(column) for column in zip(*rounds)]


def main():
    if len(sys.argv) < 3:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        lattice = folder / "lattice-40.xyz"
        side = range(40)
        lattice.write_text("".join(f"{x} {y} {z}\n" for x in side for y in side for z in side))
        print(f"{HEAD[0]:<18}" + "".join(f"{word:>11}" for word in HEAD[1:]))
        for scan in (*sys.argv[3:], lattice):
            row = figures(*sys.argv[1:3], scan, folder)
            print(f"{Path(scan).stem[:17]:<18}" + "".join(f"{value:>11.2f}" for value in row), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
