#!/usr/bin/env python3
"""Whether two programs `flowcert` give the same answers: ./dev same builds them, of two commits or on two systems, and
calls this.

usage: same_outputs.py OLDER NEWER [--generated N] [--jobs N] [SCAN ...]
       same_outputs.py --self-test

Runs compute with its options, persistence, pockets, orbit, explain, surface and --export on generated inputs and on
scans, and compares exit status, standard output, standard error and every file that is written. A scan (OBJ or XYZ) of
more than 6,000 points is given to compute, persistence and pockets; every option is tried on about 3,000 of its points.
The inputs are generated once, by OLDER. Guarantees: all bytes are
compared but the header (what made it), times, ratios to times, memory, and what is of the kernel that is the usual
one: its name, tallies of filters and of exact numbers, and the lengths of its chains.
Exit status: 0 where all is the same; 1 where something is not, or a program ends by a signal, and then the commands
are printed; 2 where the programs cannot be compared, because they refuse every input of some command.
"""
import argparse
import collections
import concurrent.futures
import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SEEDS = 1000, 2000  # of the generated inputs, level 1
SMALL = 6000        # points of a scan, up to which orbits and exports are compared as well
THINNED = 3000      # points, at least, that are left of a larger scan for them
HEADER = (
    rb'"version":"[^"]*","commit":"[^"]*","kernel":"[^"]*","compiler":"[^"]*","cgal":"[^"]*"',
    rb"flowcert [0-9.]+ \(commit [^)]*\)",
)
# What varies from run to run. The name in front, group 1, is compared.
TIMES = (
    rb'("(?:seconds|ratio_to_delaunay)":)(?:null|\{[^}]*\})',
    rb'("peak_memory_bytes":)[0-9]+',
    rb"(?m)^(Delaunay triangulation|critical points|unstable manifolds U2|stable manifolds S2|"
    rb"limits of all directions|volumes|chain complex and pairs|all after the triangulation) +[0-9.]+ (?:ms|s)(?: +[0-9.]+ x the triangulation)?$",
    rb"(?m)^(peak memory) [^\n]*$",
)
TALLIES = (
    rb'("filters":)\{(?:"[a-z_]+":\{[^}]*\},?)*\}',
    rb'("(?:predicates|primitives)":)\{(?:"[a-z_]+":\{[^}]*\},?)*\}',
    rb"(?m)^(filter failures, )[^\n]*$",
    rb"(?m)^(filter failures of )[^\n]*\n(?:  [^\n]*\n)*",
    # Which kernel is the usual one, how long a chain of constructions it keeps, and which points have exact numbers, is
    # the kernel's own affair.
    rb'("kernel":)"(?:cascade|lazy|exact)"',
    rb'("depth":)[0-9]+',
    rb"(?m)^(deepest construction )[^\n]*$",
    rb'("exact_bytes":)\{[^}]*\}',
    rb"(?m)^(bytes of exact coordinates )[^\n]*\n(?:  [^\n]*\n)*",
)
MADE = [re.compile(pattern) for pattern in HEADER]
VARYING = [re.compile(pattern) for pattern in (*TIMES, *TALLIES)]


def compared(data, of_console):
    for pattern in MADE:
        data = pattern.sub(b"", data)
    for pattern in VARYING if of_console else ():
        data = pattern.sub(rb"\1", data)
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
    yield ["compute", source, "--manifolds", "all", "--volumes", "shares", "--json", "-o", "all.jsonl"]
    yield ["persistence", source, "--json", "-o", "pairs.pers"]
    yield ["pockets", source, "--json"]
    if not is_small:
        return
    yield ["compute", source, *manifolds, "--json", "--polylines", "--skeletons", "-o", "points.jsonl"]
    yield ["compute", source, *manifolds, "--kernel", "exact", "--search", "linear", "--alone"]
    yield ["compute", source, *manifolds, "--kernel", "lazy", "--polylines", "--skeletons", "-o", "points.jsonl"]
    yield ["compute", source, "--export", "files"]
    yield ["persistence", source, "--json", "--zero", "-o", "pairs.pers"]
    yield ["persistence", source, "--json", "--seed-ties", "7"]
    yield ["orbit", source, "--from", "1/3,0.2,1/7", "--json"]
    yield ["orbit", source, "--from", "1/3,0.2,1/7", "--json", "--search", "linear"]
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


def points_of(scan):
    """The lines of a scan's points, as XYZ. Raises ValueError for files that are neither OBJ nor XYZ."""
    keyword = {".obj": 1, ".xyz": 0}.get(scan.suffix)
    if keyword is None:
        raise ValueError(f"{scan} is neither .obj nor .xyz")
    fields = [line.split() for line in scan.read_text().splitlines()]
    rows = [row for row in fields if row and not row[0].startswith("#") and (not keyword or row[0] == "v")]
    return [" ".join(row[keyword:keyword + 3]) for row in rows]


def runs_on_scan(scan, scratch):
    """The runs on a scan and, if it is large, on every so many-th of its points, which are written into scratch."""
    points = points_of(scan)
    is_small = len(points) <= SMALL
    for command in commands(str(scan.resolve()), is_small):
        yield scan.name, command, None
    if is_small:
        return
    step = len(points) // THINNED
    thinned = scratch / f"{scan.name}-thinned-{step}.xyz"
    thinned.write_text("".join(row + "\n" for row in points[::step]))
    for command in commands(str(thinned), True):
        yield thinned.name, command, None


def both_outcomes(programs, run):
    return run, *(outcome(program, run[1], run[2]) for program in programs)


def compared_runs(programs, runs, jobs):
    """A line for each run that differs or that a signal ended, one for each kind of command that both programs always
    refuse, and how many runs both refuse."""
    complaints = []
    refused = collections.defaultdict(list)  # the command without its input: whether both refuse it, run by run
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for (name, command, _), older, newer in pool.map(functools.partial(both_outcomes, programs), runs):
            line = f"{name}: flowcert {' '.join(command)}"
            statuses = [left["exit status"] for left in (older, newer)]
            refused[tuple([command[0], *command[2:]])].append(all(status >= 2 for status in statuses))
            names = [key for key in {**older, **newer} if older.get(key) != newer.get(key)]
            if names:
                complaints.append(f"{line}: {', '.join(names)} differ")
            complaints += [f"{line}: the {which} program ends by signal {-status}"
                           for which, status in zip(("older", "newer"), statuses) if status < 0]
    useless = [f"both programs refuse every input of 'flowcert {' '.join(kind)}'" for kind, each in refused.items()
               if all(each)]
    return complaints, useless, sum(map(sum, refused.values()))


def arguments():
    parser = argparse.ArgumentParser(description="whether two programs give the same answers")
    parser.add_argument("older")
    parser.add_argument("newer")
    parser.add_argument("scans", nargs="*", metavar="SCAN", type=pathlib.Path)
    parser.add_argument("--generated", type=int, default=1000, metavar="N", help="inputs that are generated (1000)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    return parser.parse_intermixed_args()


def main():
    options = arguments()
    programs = [str(pathlib.Path(name).resolve()) for name in (options.older, options.newer)]
    inputs = generated(programs[0], options.generated)
    runs = [(name, command, points) for name, points in inputs for command in commands("-", True)]
    with tempfile.TemporaryDirectory() as scratch:
        try:
            for scan in options.scans:
                runs += runs_on_scan(scan, pathlib.Path(scratch))
        except (OSError, ValueError) as error:
            print("error:", error, file=sys.stderr)
            return 2
        complaints, useless, refused = compared_runs(programs, runs, options.jobs)
    for complaint in complaints:
        print(complaint)
    print(f"{len(runs)} commands on {len(inputs)} generated inputs and {len(options.scans)} scans: "
          f"{len(complaints)} complaints; {refused} refuse the input")
    for line in useless:
        print("error:", line, file=sys.stderr)
    return 1 if complaints else 2 if useless else 0


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)

        def result(older, newer):
            """What is said of two shell scripts, which are run with a command that they may refuse for input b."""
            for name, body in (("older", older), ("newer", newer)):
                (scratch / name).write_text(f"#!/bin/sh\n{body}\n")
                (scratch / name).chmod(0o755)
            programs = [str(scratch / name) for name in ("older", "newer")]
            return compared_runs(programs, [(name, ["compute", name, "--json"], None) for name in "ab"], 1)

        both = [f"{name}: flowcert compute {name} --json: " for name in "ab"]
        row = "echo 'critical points               {}'; echo '{{\"seconds\":{{\"all\":{}}}}}'"
        right = row.format("3.1 ms   0.46 x the triangulation", 1)
        assert result(right, row.format("2.75 s   1.00 x the triangulation", 2)) == ([], [], 0)
        differ = [line + "standard output differ" for line in both]
        u2 = """echo '{{"u2":{{"kernel":"{}","orbits":{},"depth":{}}}}}'; echo 'deepest construction (paper): {}'"""
        assert result(u2.format("lazy", 2, 1000, 1000), u2.format("cascade", 2, 3210, "3,210")) == ([], [], 0)
        assert result(u2.format("lazy", 2, 1, 1), u2.format("cascade", 3, 1, 1)) == (differ, [], 0)
        assert result(u2.format("lazy", 2, 1, 1), u2.format("other", 2, 1, 1)) == (differ, [], 0)
        assert result(right, row.format("3.2 ms   0.46 x the octahedron", 1)) == (differ, [], 0)
        assert result("echo 'orbits   3 s   of 4'", "echo 'orbits   5 s   of 4'") == (differ, [], 0)
        assert result("echo 1 >&2", "echo 2 >&2")[0] == [line + "standard error differ" for line in both]
        assert result("echo 1 >made", "echo 2 >made")[0] == [line + "made differ" for line in both]
        assert result("true", "echo 2 >made")[0] == [line + "made differ" for line in both]
        assert result("true", "exit 1")[0] == [line + "exit status differ" for line in both]
        useless = ["both programs refuse every input of 'flowcert compute --json'"]
        assert result("exit 2", "exit 2") == ([], useless, 2)
        assert result("[ $2 = a ] || exit 2", "[ $2 = a ] || exit 2") == ([], [], 1)
        ends = [f"{line}the {which} program ends by signal 9" for line in both for which in ("older", "newer")]
        assert result("kill -9 $$", "kill -9 $$") == (ends, [], 0)

        rows = [f"{k} {k + 1}.5 -{k}" for k in range(2 * SMALL)]
        large = scratch / "large.obj"
        large.write_text("# a scan\n" + "".join(f"v {row}\nvn 1 0 0\n" for row in rows))
        thinned = [command[1] for _, command, _ in runs_on_scan(large, scratch)][-1]
        assert pathlib.Path(thinned).read_text().splitlines() == rows[::4]
        (scratch / "small.xyz").write_text("# a scan\n" + "\n".join(rows[:SMALL]))
        assert len(list(runs_on_scan(scratch / "small.xyz", scratch))) == len(list(commands("-", True)))
        assert len(list(runs_on_scan(large, scratch))) == len([*commands("-", False), *commands("-", True)])
    print("finds differences but those of times, commands that are always refused, and crashes; thins large scans")
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
