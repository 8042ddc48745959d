"""Every command under limits of its memory, from too little to enough.

Each time its status and its outputs are those that it has without a limit, or its status is 2 with one line, and
nothing is left in its folder. The last limit is enough. FLOWCERT_PROPERTY_SCALE=4 tries 40 limits and not 8.

Usage: memory_limits_test.py FLOWCERT ORACLE
"""

import functools
import os
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile

FLOWCERT, ORACLE = (os.path.abspath(path) for path in sys.argv[1:3])
LIMITS = 40 if float(os.environ.get("FLOWCERT_PROPERTY_SCALE", "1")) > 1 else 8
MEGABYTE = 1 << 20
MOST = 2048 * MEGABYTE


def commands():
    """(name, words, files that are written)"""
    own = [
        ("compute", ["compute", "points.xyz", "--manifolds", "all", "-o", "out.jsonl"], ["out.jsonl"]),
        ("compute gz", ["compute", "points.xyz.gz", "-o", "-"], []),
        ("surface", ["surface", "points.xyz", "-o", "out.ply"], ["out.ply"]),
        ("persistence", ["persistence", "points.xyz", "-o", "out.pers"], ["out.pers"]),
        ("pockets", ["pockets", "points.xyz", "--json"], []),
        ("medial", ["medial", "points.xyz", "--angle", "60", "--json"], []),
        ("stats", ["stats", "points.xyz"], []),
        ("view", ["view", "points.xyz", "-o", "out.html"], ["out.html"]),
        ("explain", ["explain", "points.xyz", "--ids", "0,1"], []),
        ("orbit", ["orbit", "points.xyz", "--from", "0.3,0.2,0.1"], []),
        ("locate", ["locate", "points.xyz", "--positions", "few.xyz"], []),
        ("check", ["check", "points.xyz", "claim.jsonl"], []),
        ("check pairs", ["check", "points.xyz", "pairs.txt"], []),
        ("generate", ["generate", "--level", "1", "--cases", "300"], []),
        ("verify", ["verify", "--json"], []),
        ("conformance", ["conformance", "--against", "cp {in} {out}", "--group", "flat-inputs", "--json"], []),
        ("fuzz", ["fuzz", "--replay", "few.xyz"], []),
        ("help", ["compute", "--help"], []),
    ]
    oracle = [
        ("oracle stationary", ["stationary", "few.xyz"], []),
        ("oracle orbit", ["orbit", "few.xyz", "--from", "0.3,0.2,0.1"], []),
        ("oracle certify", ["certify", "points.xyz", "claim.jsonl", "--sample", "3"], []),
    ]
    return [(name, [FLOWCERT, *words], files) for name, words, files in own] + [
        (name, [ORACLE, *words], files) for name, words, files in oracle
    ]


def run(words, folder, limit=None, stack=None):
    def limited():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if stack is not None:
            resource.setrlimit(resource.RLIMIT_STACK, (stack, stack))
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    with open(folder / "answers.txt") as answers:  # verify reads them, and nothing else does
        return subprocess.run(words, cwd=folder, capture_output=True, preexec_fn=limited, stdin=answers)


class Outcome:
    def __init__(self, finished, folder, files):
        self.status, self.err = finished.returncode, finished.stderr
        # Times, how many times the triangulation's they are, and the peak of memory.
        self.out = re.sub(rb" +[0-9.,]+ (m?s|MiB|x the)\b|\"seconds\":[0-9.e-]+", b"", finished.stdout)
        self.files = {}
        for name in files:
            path = folder / name
            self.files[name] = path.read_bytes() if path.exists() else None
            path.unlink(missing_ok=True)

    def is_as(self, other):
        return (self.status, self.out, self.files) == (other.status, other.out, other.files)

    def is_refusal(self, usual):
        """One line, and no file but one that is complete: memory may end when all is written."""
        is_whole = all(content in (None, usual.files[name]) for name, content in self.files.items())
        return self.status == 2 and self.err.count(b"\n") == 1 and is_whole


def least(words, folder, is_enough, low=1, parts=8):
    """The least limit in megabytes that is enough, to a part of it."""
    high = low
    while not is_enough(run(words, folder, high * MEGABYTE)):
        low, high = high, 2 * high
        assert high <= MOST // MEGABYTE, f"{words}: two runs are never the same"
    while high - low > max(1, high // parts):
        middle = (low + high) // 2
        low, high = (low, middle) if is_enough(run(words, folder, middle * MEGABYTE)) else (middle, high)
    return high


@functools.lru_cache
def least_to_load(program, folder):
    return least([program, "--help"], folder, lambda finished: finished.returncode == 0, parts=100)


def limits_of(words, folder, usual, files):
    """From where the program can be loaded to where it has all that it needs."""
    loads = least_to_load(words[0], folder)
    enough = least(words, folder, lambda finished: Outcome(finished, folder, files).is_as(usual), loads)
    count = LIMITS - 1
    return [loads * MEGABYTE + (enough - loads) * MEGABYTE * k // count for k in range(count + 1)]


def problems(name, words, files, folder):
    before = set(os.listdir(folder))
    usual = Outcome(run(words, folder), folder, files)
    if usual.status not in (0, 1):
        yield f"{name}: does not run: {usual.err.decode(errors='replace')}"
        return
    refused = 0
    for limit in limits_of(words, folder, usual, files):
        outcome = Outcome(run(words, folder, limit), folder, files)
        where = f"{name}, {limit / MEGABYTE:.1f} MB"
        if not outcome.is_as(usual) and not outcome.is_refusal(usual):
            yield f"{where}: status {outcome.status}, {len(outcome.out)} bytes, {outcome.err[-300:]!r}"
        refused += not outcome.is_as(usual)
        left = set(os.listdir(folder)) - before
        if left:
            yield f"{where}: leaves {left}"
            before |= left
    print(f"{name}: {refused} of {LIMITS} limits are refused")


def problems_without_threads(folder):
    """A thread takes as much as a stack may have, which is more here than there is: there is none but the first."""
    for name, words, files in commands():
        if name not in ("compute", "surface", "persistence", "pockets", "view", "check", "conformance"):
            continue
        words = words + (["--jobs", "8"] if name == "conformance" else ["--threads", "64"])
        usual = Outcome(run(words, folder), folder, files)
        outcome = Outcome(run(words, folder, MOST, 2 * MOST), folder, files)
        if not outcome.is_as(usual):
            yield f"{name} without threads: status {outcome.status}, {outcome.err[-300:]!r}"


def make_files(folder):
    draw = random.Random(41)
    rows = [[round(draw.uniform(0, 1), 3) for _ in range(3)] for _ in range(600)]
    text = "".join("{} {} {}\n".format(*row) for row in rows)
    (folder / "points.xyz").write_text(text)
    (folder / "few.xyz").write_text("".join(text.splitlines(True)[:9]))
    cases = subprocess.run([FLOWCERT, "generate"], capture_output=True, text=True, check=True).stdout
    ids = [line.split()[1] for line in cases.splitlines() if line.startswith("case ")]
    (folder / "answers.txt").write_text("".join(f"answer {id}\n0,,,,,0\nend\n" for id in ids))
    subprocess.run(["gzip", "-k", "points.xyz"], cwd=folder, check=True)
    for command in (
        ["compute", "points.xyz", "--manifolds", "all", "-o", "claim.jsonl"],
        ["persistence", "points.xyz", "-o", "pairs.txt"],
    ):
        subprocess.run([FLOWCERT, *command], cwd=folder, check=True, capture_output=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_files(folder)
        found = [problem for command in commands() for problem in problems(*command, folder)]
        found += problems_without_threads(folder)
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
