#!/usr/bin/env python3
"""Whether two versions of the programs give the same answers: ./dev same builds them, of two commits or on two systems,
and calls this.

usage: same_outputs.py OLDER NEWER [--generated N] [--claims N] [--jobs N] [--without-python] [SCAN ...]
       same_outputs.py --self-test

OLDER and NEWER are build folders, with flowcert, flowcert-oracle, flowcert-proof and the Python package. Runs what
same_runs.py lists, and compares exit status, standard output, standard error and every file that is written. A scan
(OBJ or XYZ) of more than 6,000 points is given to compute, persistence and pockets; every option is tried on about
3,000 of its points.
Inputs and claims are made once, by OLDER. Guarantees: all bytes are compared but the header (what made it), a page's
program, times, ratios to times, memory, and what is of the kernel that is the usual one: its name, tallies of filters
and of exact numbers, and the lengths of its chains.
Exit status: 0 where all is the same; 1 where something is not, or a program ends by a signal, and then the commands
are printed; 2 where the programs cannot be compared, because they refuse every input of some command.
"""
import argparse
import collections
import concurrent.futures
import functools
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import same_runs
from same_runs import Run

HEADER = (
    rb'"version":"[^"]*","commit":"[^"]*","kernel":"[^"]*","compiler":"[^"]*","cgal":"[^"]*"',
    rb'"(?:version|commit|kernel|compiler|cgal)": "[^"]*"',
    rb"flowcert [0-9.]+ \(commit (?:[^\n]*?; CGAL )?[^)]*\)",  # a compiler's version may have parentheses
    # A page carries its program, which ./dev web tests; its data are compared.
    rb"SHA-256 of its sources: [0-9a-f]{64}",
    rb"(?s)<script>\n.*?</script>",
)
# What varies from run to run. The name in front, group 1, is compared.
TIMES = (
    rb'("(?:seconds|ratio_to_delaunay)":)(?:null|\{[^}]*\})',
    rb'("peak_memory_bytes":)[0-9]+',
    rb"(?m)^(Delaunay triangulation|critical points|unstable manifolds U2|stable manifolds S2|limits of all directions|"
    rb"volumes|(?:chain complex and )?pairs|pockets after it|all after the triangulation)"
    rb" +[0-9.]+ (?:ms|s)(?: +[0-9.]+ x the triangulation)?$",
    rb"(?m)^(peak memory) [^\n]*$",
    rb'("(?:seconds|cases_per_second|cases_per_second_of_one_job)": )[0-9.e+-]+',
    rb"(?m)^(cases a second) [^\n]*$",
    rb"(?m)^(  points +cases +)cases/s of one job\n(?:  [^\n]*\n)*",
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
    """The digest of what is compared: outputs have gigabytes, and many runs wait for a slower one before them."""
    for pattern in MADE:
        data = pattern.sub(b"", data)
    for pattern in VARYING if of_console else ():
        data = pattern.sub(rb"\1", data)
    return hashlib.sha256(data).digest()


def outcome(folder, run):
    """Everything that a run leaves, by name, with the programs of that folder."""
    program = folder / run.program
    environment = None
    if run.program == "python3":
        program = "/usr/bin/python3"
        environment = {**os.environ, "PYTHONPATH": str(folder / "python"), "PYTHONDONTWRITEBYTECODE": "1"}
    with tempfile.TemporaryDirectory() as place:
        for name, content in run.files:
            (pathlib.Path(place) / name).write_bytes(content)
        done = subprocess.run([program, *run.words], input=run.points, capture_output=True, cwd=place, check=False,
                              env=environment)
        left = {"exit status": done.returncode, "standard output": compared(done.stdout, True),
                "standard error": compared(done.stderr, True)}
        for path in sorted(pathlib.Path(place).rglob("*")):
            if path.is_file():
                left[str(path.relative_to(place))] = compared(path.read_bytes(), False)
    return left


def both_outcomes(folders, run):
    return run, *(outcome(folder, run) for folder in folders)


def compared_runs(folders, runs, jobs):
    """A line for each run that differs or that a signal ended, one for each kind of command that both programs always
    refuse, and how many runs both refuse."""
    complaints = []
    refused = collections.defaultdict(list)  # by kind: whether both refuse it, run by run
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for run, older, newer in pool.map(functools.partial(both_outcomes, folders), runs):
            statuses = [left["exit status"] for left in (older, newer)]
            refused[run.kind()].append(all(status >= 2 for status in statuses))
            names = [key for key in {**older, **newer} if older.get(key) != newer.get(key)]
            if names:
                complaints.append(f"{run.line()}: {', '.join(names)} differ")
            complaints += [f"{run.line()}: the {which} program ends by signal {-status}"
                           for which, status in zip(("older", "newer"), statuses) if status < 0]
    useless = [f"both refuse every input of '{' '.join(kind)}'" for kind, each in refused.items() if all(each)]
    return complaints, useless, sum(map(sum, refused.values()))


def arguments():
    parser = argparse.ArgumentParser(description="whether two versions give the same answers")
    parser.add_argument("older", type=pathlib.Path)
    parser.add_argument("newer", type=pathlib.Path)
    parser.add_argument("scans", nargs="*", metavar="SCAN", type=pathlib.Path)
    parser.add_argument("--generated", type=int, default=1000, metavar="N", help="inputs that are generated (1000)")
    parser.add_argument("--claims", type=int, default=2000, metavar="N", help="claims that are mutated (2000)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--without-python", action="store_true", help="without the Python package")
    return parser.parse_intermixed_args()


def all_runs(program, options, scratch):
    inputs = same_runs.generated(program, options.generated)
    cases = same_runs.vector_cases()
    runs = [*same_runs.runs_on_generated(inputs), *same_runs.runs_of_proofs(program, inputs),
            *same_runs.runs_on_judgements(cases),
            *same_runs.runs_on_mutated_claims(program, cases, options.claims),
            *same_runs.runs_without_points(program), *same_runs.runs_on_files_of_others()]
    for scan in options.scans:
        runs += same_runs.runs_on_scan(scan, scratch)
    return [run for run in runs if run.program != "python3" or not options.without_python]


def main():
    options = arguments()
    folders = [folder.resolve() for folder in (options.older, options.newer)]
    with tempfile.TemporaryDirectory() as scratch:
        try:
            runs = all_runs(folders[0] / "flowcert", options, pathlib.Path(scratch))
        except (OSError, ValueError) as error:
            print("error:", error, file=sys.stderr)
            return 2
        complaints, useless, refused = compared_runs(folders, runs, options.jobs)
    for complaint in complaints:
        print(complaint)
    print(f"{len(runs)} commands, also on {len(options.scans)} scans: {len(complaints)} complaints; "
          f"{refused} refuse the input")
    for line in useless:
        print("error:", line, file=sys.stderr)
    return 1 if complaints else 2 if useless else 0


def result_of_scripts(scratch, older, newer, program="flowcert"):
    """What is said of two shell scripts, which are run with a command that they may refuse for input b."""
    folders = [scratch / "older", scratch / "newer"]
    for folder, body in zip(folders, (older, newer)):
        folder.mkdir(exist_ok=True)
        (folder / program).write_text(f"#!/bin/sh\n{body}\n")
        (folder / program).chmod(0o755)
    return compared_runs(folders, [Run(name, program, ("compute", name, "--json")) for name in "ab"], 1)


def test_of_comparisons(scratch):
    def result(older, newer):
        return result_of_scripts(scratch, older, newer)

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
    useless = ["both refuse every input of 'flowcert compute --json'"]
    assert result("exit 2", "exit 2") == ([], useless, 2)
    assert result("[ $2 = a ] || exit 2", "[ $2 = a ] || exit 2") == ([], [], 1)
    ends = [f"{line}the {which} program ends by signal 9" for line in both for which in ("older", "newer")]
    assert result("kill -9 $$", "kill -9 $$") == (ends, [], 0)
    assert len(result_of_scripts(scratch, "echo 1", "echo 2", "flowcert-oracle")[0]) == 2


def test_of_scans(scratch):
    rows = [f"{k} {k + 1}.5 -{k}" for k in range(2 * same_runs.SMALL)]
    large, small = scratch / "large.obj", scratch / "small.xyz"
    large.write_text("# a scan\n" + "".join(f"v {row}\nvn 1 0 0\n" for row in rows))
    small.write_text("# a scan\n" + "\n".join(rows[:same_runs.SMALL]))
    runs = list(same_runs.runs_on_scan(large, scratch))
    assert pathlib.Path(runs[-1].words[1]).read_text().splitlines() == rows[::4]
    of_small = [run.kind() for run in same_runs.runs_on("-", "-", True)]
    assert len(list(same_runs.runs_on_scan(small, scratch))) == len(of_small)
    assert len(runs) == len(of_small) + len(list(same_runs.runs_on("-", "-", False)))


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        test_of_comparisons(pathlib.Path(folder))
        test_of_scans(pathlib.Path(folder))
    print("finds differences but those of times, commands that are always refused, and crashes; thins large scans")
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
