#!/usr/bin/env python3
"""Whether two programs `flowcert` give the same answers: ./dev same COMMIT builds the older one and calls this.

usage: same_outputs.py OLDER NEWER [--generated N] [--jobs N] [SCAN ...]

Runs compute with its options, persistence, orbit, surface and --export on generated inputs and on scans, and compares
exit status, standard output, standard error and every file that is written. Guarantees: all bytes are compared but the
header (what made it), times, ratios to times, memory, and tallies of filters and of exact numbers. Exit status: 0
where all is the same; 1 where something is not, and then the commands are printed; 2 where the programs cannot be
compared.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SEEDS = 1000, 2000  # of the generated inputs, level 1
SMALL = 6000        # points of a scan, up to which orbits and exports are compared as well
HEADER = (
    rb'"version":"[^"]*","commit":"[^"]*","kernel":"[^"]*","compiler":"[^"]*","cgal":"[^"]*"',
    rb"flowcert [0-9.]+ \(commit [^)]*\)",
)
TIMES = (
    rb'"(?:seconds|ratio_to_delaunay)":(?:null|\{[^}]*\})',
    rb'"peak_memory_bytes":[0-9]+',
    rb"(?m)^[A-Za-z][^\n]* [0-9.,]+ (?:ns|us|ms|s|min|h)(?: [^\n]*| *)$",
    rb"(?m)^peak memory [^\n]*$",
)
TALLIES = (
    rb'"filters":\{(?:"[a-z_]+":\{[^}]*\},?)*\}',
    rb'"(?:predicates|primitives)":\{(?:"[a-z_]+":\{[^}]*\},?)*\}',
    rb"(?m)^filter failures, [^\n]*$",
    rb"(?m)^filter failures of [^\n]*\n(?:  [^\n]*\n)*",
    # Which points have coordinates that a filter left to exact numbers is the filter's own affair.
    rb'"exact_bytes":\{[^}]*\}',
    rb"(?m)^bytes of exact coordinates [^\n]*\n(?:  [^\n]*\n)*",
)
MADE = [re.compile(pattern) for pattern in HEADER]
VARYING = [re.compile(pattern) for pattern in (*TIMES, *TALLIES)]


def compared(data, of_console):
    for pattern in (*MADE, *VARYING) if of_console else MADE:
        data = pattern.sub(b"", data)
    return data


def outcome(program, arguments, points):
    """Everything that a run leaves, by name."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, *arguments], input=points, capture_output=True, cwd=folder, check=False)
        left = {"exit status": done.returncode, "standard output": compared(done.stdout, True),
                "standard error": compared(done.stderr, True)}
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_file():
                left[str(path.relative_to(folder))] = compared(path.read_bytes(), False)
    return left


def commands(source, is_small):
    manifolds = ["--manifolds", "u2,s2", "--stats"]
    yield ["compute", source, "--json", "-o", "points.jsonl"]
    yield ["compute", source, "--manifolds", "s2", "--stats", "--skeletons", "-o", "points.jsonl"]
    if not is_small:
        return
    yield ["compute", source, *manifolds, "--json", "--polylines", "--skeletons", "-o", "points.jsonl"]
    yield ["compute", source, *manifolds, "--kernel", "exact", "--search", "linear", "--alone"]
    yield ["compute", source, "--export", "files"]
    yield ["persistence", source, "--json", "--zero", "-o", "pairs.pers"]
    yield ["orbit", source, "--from", "1/3,0.2,1/7", "--json"]
    yield ["orbit", source, "--from", "1/3,0.2,1/7", "--kernel", "exact"]
    yield ["explain", source, "--ids", "0,1", "--json"]
    yield ["surface", source, "--select", "largest-gaps=3", "-o", "surface.ply"]
    yield ["surface", source, "--select", "persistence>1", "-o", "surface.off", "--json"]


def generated(program, count):
    """The points of that many cases, as a point file each."""
    found = []
    for seed in SEEDS:
        command = [program, "generate", "--level", "1", "--seed", str(seed)]
        listing = subprocess.run(command, check=True, capture_output=True)
        lines = iter(listing.stdout.decode().splitlines())
        for line in lines:
            if line.startswith("case "):
                rows = [next(lines) for _ in range(int(line.split()[2]))]
                found.append((line.split()[1], "\n".join(["# a case", *rows, ""]).encode()))
    return found[:count]


def arguments():
    parser = argparse.ArgumentParser(description="whether two programs give the same answers")
    parser.add_argument("older")
    parser.add_argument("newer")
    parser.add_argument("scans", nargs="*", metavar="SCAN")
    parser.add_argument("--generated", type=int, default=1000, metavar="N", help="inputs that are generated (1000)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    return parser.parse_intermixed_args()


def main():
    options = arguments()
    programs = [str(pathlib.Path(name).resolve()) for name in (options.older, options.newer)]
    runs = [(name, command, points) for name, points in generated(programs[0], options.generated)
            for command in commands("-", True)]
    for scan in map(pathlib.Path, options.scans):
        is_small = scan.read_bytes().count(b"\n") < SMALL
        runs += [(scan.name, command, None) for command in commands(str(scan.resolve()), is_small)]

    def compare(run):
        return run, *(outcome(program, run[1], run[2]) for program in programs)

    different = refused = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for (name, command, _), older, newer in pool.map(compare, runs):
            refused += older["exit status"] == 2
            names = [key for key in {**older, **newer} if older.get(key) != newer.get(key)]
            if names:
                different += 1
                print(f"{name}: flowcert {' '.join(command)}: {', '.join(names)} differ")
    print(f"{len(runs)} commands on {options.generated} generated inputs and {len(options.scans)} scans: "
          f"{different} differ; {refused} refuse the input")
    if refused * 2 > len(runs):
        print("error: most commands refuse their input", file=sys.stderr)
        return 2
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
