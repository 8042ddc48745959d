#!/usr/bin/env python3
"""certificates_test.py FLOWCERT PROOF ROOT

`flowcert-proof` proves what `flowcert` computes: the triangulation, the list of stationary points and the pairs of the
regressions, of 1,000 drawn inputs, of the Stanford bunny and of the kitten. spec/proof.py proves every tenth of the
drawn ones, too, and agrees on what is changed: cells, fields of records, keys, pairs. The bunny and the kitten are
those of Debian's packages; without them their proofs are left out, and a line says so.
A list with a key that is not proved is never proved. FLOWCERT_PROPERTY_SCALE draws more inputs, or fewer.
"""
# CITES: FC-CERT-03 FC-CERT-04 FC-CERT-05 FC-CERT-06 FC-FILE-48 FC-FILE-49 FC-FILE-51
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

FLOWCERT, PROOF, ROOT = sys.argv[1], sys.argv[2], Path(sys.argv[3])
sys.path.insert(0, str(ROOT / "tests/bench"))
import paper_tables  # noqa: E402
CASES = max(1, round(1000 * float(os.environ.get("FLOWCERT_PROPERTY_SCALE", "1"))))
BUNNY = Path("/usr/share/glmark2/models/bunny.obj")
failures = []


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)


def expect(truth, what, result=None):
    if not truth:
        failures.append(what)
        print("FAIL:", what, *([result.returncode, result.stdout.strip(), result.stderr.strip()] if result else []))


def computed(source, folder):
    """The files of an input: its points, certificate, list, and pairs as text and as JSON."""
    names = [folder / name for name in ("points.f64", "cells.fcert", "list.jsonl", "pairs.pers", "pairs.json")]
    points, cells, records, pairs, exact_pairs = names
    for path in names:
        path.unlink(missing_ok=True)
    for command in (("points", source, "-o", points),
                    ("compute", source, "-o", records, "--certificate", cells, "--threads", 1),
                    ("persistence", source, "-o", pairs, "--threads", 1)):
        result = run(FLOWCERT, *command)
        if result.returncode != 0 and command[0] != "persistence":
            raise RuntimeError(f"flowcert {command}: {result.stderr}")
    exact_pairs.write_text(run(FLOWCERT, "persistence", source, "--json", "--threads", 1).stdout)
    return names


def prove_whole(name, source, folder, with_python):
    points, cells, records, pairs, exact_pairs = computed(source, folder)
    for wanted in (pairs, exact_pairs):
        if not wanted.exists():  # a squared distance beyond the doubles
            continue
        result = run(PROOF, points, cells, records, "--pairs", wanted)
        expect(result.returncode == 0 and result.stdout.count("proved: all") == 2, f"{name}: not proved", result)
    if with_python:
        result = run(sys.executable, ROOT / "spec/proof.py", points, cells, records)
        expect(result.returncode == 0, f"{name}: not proved by proof.py", result)


def drawn_inputs(count, seed):
    with subprocess.Popen([FLOWCERT, "generate", "--level", "2", "--cases", str(count), "--seed", str(seed)],
                          stdout=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            if line.startswith("case "):
                yield [next(process.stdout) for _ in range(int(line.split()[2]))]


def write_points(points, path):
    path.write_text("".join(points) or "# no points\n")


def prove_drawn(folder):
    source, count = folder / "drawn.xyz", 0
    for k, points in enumerate(drawn_inputs(CASES, 45)):
        write_points(points, source)
        prove_whole(f"drawn input {k}", source, folder, k % 10 == 0)
        count += 1
    expect(count == CASES, f"{count} of {CASES} inputs were drawn")


def changed_records(text, rng):
    """A list in which one thing is wrong, and what."""
    lines = text.splitlines()
    k = rng.randrange(1, len(lines))
    what = rng.choice(("index", "contact", "center", "squared_distance", "center_double", "missing", "twice", "order",
                       "key", "count"))
    record = json.loads(lines[k])
    if what == "missing":
        del lines[k]
    elif what == "twice":
        lines.insert(k, lines[k])
    elif what == "order":
        if len(lines) < 3:
            return None, what
        other = 1 + k % (len(lines) - 1)
        lines[k], lines[other] = lines[other], lines[k]
    elif what == "count":
        head = json.loads(lines[0])
        head["critical"][rng.randrange(4)] += 1
        lines[0] = json.dumps(head, separators=(",", ":"))
    else:
        if what == "index":
            record["index"] = 1 if record["index"] != 1 else 2
        elif what == "contact":
            record["contact"] = record["contact"][:-1] + [record["contact"][-1] + 1]
        elif what == "center":
            record["center"][rng.randrange(3)] += "1"
        elif what == "squared_distance":
            record["squared_distance"] += "1"
        elif what == "center_double":
            axis = rng.randrange(3)
            record["center_double"][axis] = (record["center_double"][axis] or 0.0) + 1.0
        else:
            record["limits"] = [[0], [0]]
        lines[k] = json.dumps(record, separators=(",", ":"))
    return "".join(line + "\n" for line in lines), what


def refuse_changed(folder, rounds):
    """Lists and certificates with a fault: neither checker proves them, and both say the same."""
    rng, source, kinds = random.Random(451), folder / "drawn.xyz", set()
    for points in drawn_inputs(rounds, 46):
        if len(points) < 2:
            continue
        write_points(points, source)
        scan, cells, records, *_ = computed(source, folder)
        text, what = changed_records(records.read_text(), rng)
        if text is not None:
            records.write_text(text)
            ours = run(PROOF, scan, cells, records)
            theirs = run(sys.executable, ROOT / "spec/proof.py", scan, cells, records)
            expect(ours.returncode in (1, 2), f"a list with another {what} is proved", ours)
            expect(ours.returncode == theirs.returncode, f"another {what}: {theirs.stdout}{theirs.stderr}", ours)
            kinds.add(what)
        head, _, body = cells.read_bytes().partition(b"\n\n")
        if body:
            k = rng.randrange(len(body))
            cells.write_bytes(head + b"\n\n" + body[:k] + bytes([body[k] ^ 1 << rng.randrange(8)]) + body[k + 1:])
            ours, theirs = run(PROOF, scan, cells), run(sys.executable, ROOT / "spec/proof.py", scan, cells)
            expect(ours.returncode == theirs.returncode, f"a changed byte: {theirs.stdout}{theirs.stderr}", ours)
    expect(rounds < 100 or len(kinds) == 10, f"changes of these kinds alone: {sorted(kinds)}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        regressions = sorted((ROOT / "fuzz/regressions").glob("*.xyz"))
        expect(len(regressions) > 2, "there are no regressions")
        for source in regressions:
            prove_whole(source.name, source, folder, True)
        prove_drawn(folder)
        refuse_changed(folder, max(5, CASES // 10))
        scans = [*([BUNNY] if BUNNY.exists() else []), *paper_tables.kitten(folder)]
        if len(scans) < 2:
            print("a scan of Debian's packages is not there: it is not proved")
        for scan in scans:
            prove_whole(scan.name, scan, folder, False)
    print(f"{len(regressions)} regressions and {CASES} drawn inputs; {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
