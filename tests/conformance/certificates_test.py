#!/usr/bin/env python3
"""certificates_test.py FLOWCERT PROOF ROOT [--full]

`flowcert-proof` and spec/proof.py prove what `flowcert` computes, and nothing else:

- of drawn degenerate inputs, large ones among them, the list of stationary points and the pairs, by three
  triangulations each where there are several: the program's, its one of the turned points, and one by points in a
  random order;
- of the regressions, the Stanford bunny and the kitten, by the program's own (the scans by flowcert-proof alone);
- corrupted certificates get the same exit status from both, and it is 0 just for Delaunay triangulations;
- forged lists are not proved.

The bunny and the kitten are those of Debian's packages; without them their proofs are left out, and a line says so.
FLOWCERT_PROPERTY_SCALE draws more of all, or fewer, and FLOWCERT_PROPERTY_SEED others. --full is the whole campaign,
which takes an hour. PROOF may be built with sanitizers: what these say on standard error is a failure.
"""
# CITES: FC-CERT-02 FC-CERT-03 FC-CERT-04 FC-CERT-05 FC-CERT-06 FC-FILE-48 FC-FILE-49 FC-FILE-50 FC-FILE-51
import collections
import contextlib
import io
import itertools
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest.mock
from pathlib import Path

import corrupted_certificates as corrupted
import forged_lists
import large_degenerate_points
from certificate_bytes import decode
from exact_delaunay import dot, is_delaunay

FLOWCERT, PROOF, ROOT = sys.argv[1], sys.argv[2], Path(sys.argv[3])
sys.path[:0] = [str(ROOT / "tests/bench"), str(ROOT / "spec")]
import paper_tables  # noqa: E402
import proof  # noqa: E402
SCALE = float(os.environ.get("FLOWCERT_PROPERTY_SCALE", "1"))
SEED = int(os.environ.get("FLOWCERT_PROPERTY_SEED", "45"))
IS_FULL = "--full" in sys.argv
DRAWN, LARGE, CORRUPTED, FORGED = (
    max(1, round(n * SCALE)) for n in ((9800, 500, 2000, 500) if IS_FULL else (1000, 3, 200, 100)))
BUNNY = Path("/usr/share/glmark2/models/bunny.obj")
failures, told = [], collections.Counter()


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def expect(truth, what, *results):
    if not truth:
        failures.append(what)
        print("FAIL:", what, *(word for result in results for word in (
            result.returncode, result.stdout.strip(), result.stderr.strip())), flush=True)


def proof_program(*arguments):
    """flowcert-proof. Sanitizers end it with 1, too, so that standard error counts."""
    result = run(PROOF, *arguments)
    expect(result.returncode in (0, 1, 2) and result.stderr.count("\n") == (result.returncode == 2),
           f"flowcert-proof {arguments}", result)
    return result


def proof_py(*arguments):
    """spec/proof.py, in this process, which saves most of its time."""
    words = ["proof.py", *map(str, arguments)]
    out, errors = io.TextIOWrapper(io.BytesIO(), "utf-8"), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors), \
            unittest.mock.patch.object(sys, "argv", words):
        status = proof.main()
    out.seek(0)
    return subprocess.CompletedProcess(words, status, out.read(), errors.getvalue())


def compute(source, records, certificate):
    result = run(FLOWCERT, "compute", source, "-o", records, "--certificate", certificate, "--threads", 1)
    if result.returncode != 0:
        raise RuntimeError(f"flowcert compute {source}: {result.stderr}")


# ---- What is right


def prove_whole(name, source, scan, folder, with_python=True):
    """The certificate, the list and the pairs of a file, of which the scan has the points; returns their files."""
    certificate, records, pairs, exact_pairs = (folder / f"own.{end}" for end in ("fcert", "jsonl", "pers", "json"))
    compute(source, records, certificate)
    pairs.unlink(missing_ok=True)
    exact_pairs.write_text(run(FLOWCERT, "persistence", source, "--json", "-o", pairs, "--threads", 1).stdout)
    if not exact_pairs.stat().st_size:  # a squared distance is beyond the doubles
        exact_pairs.write_text(run(FLOWCERT, "persistence", source, "--json", "--threads", 1).stdout)
    prove(name, scan, certificate, records, exact_pairs, with_python)
    if pairs.exists():
        result = proof_program(scan, certificate, "--pairs", pairs)
        expect(result.returncode == 0 and result.stdout.count("proved: all") == 2, f"{name}: pairs", result)
    return certificate, records, exact_pairs


def prove_older_pairs(name, scan, certificate, records, exact_pairs):
    """Programs before 1.0.0 wrote times, too."""
    times = '"seconds":{"pairs":0.25},"ratio_to_delaunay":{"pairs":1.5},"has_zero"'
    exact_pairs.write_text(exact_pairs.read_text().replace('"has_zero"', times))
    prove(f"{name}, with times", scan, certificate, records, exact_pairs, with_python=False)


def prove(name, scan, certificate, records, exact_pairs, with_python=True):
    result = proof_program(scan, certificate, records, "--pairs", exact_pairs)
    expect(result.returncode == 0 and result.stdout.count("proved: all") == 2, f"{name}: not proved", result)
    if with_python:
        result = proof_py(scan, certificate, records)
        expect(result.returncode == 0, f"{name}: not proved by proof.py", result)


def drawn_inputs(rng):
    with subprocess.Popen([FLOWCERT, "generate", "--level", "3", "--cases", str(DRAWN), "--seed", str(SEED)],
                          stdout=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            if line.startswith("case "):
                yield line.split()[1], [next(process.stdout).split() for _ in range(int(line.split()[2]))]
    for k in range(LARGE):
        kind, points = large_degenerate_points.draw(k, rng)
        told["large inputs"] += 1
        yield f"{kind} {k}", [list(map(str, point)) for point in points]


def write_points(rows, path):
    path.write_text("".join(" ".join(map(str, row)) + "\n" for row in rows))


def turned(rows, rng):
    """The rows, turned so that axes go to axes. CGAL prefers points of a sphere by their coordinates, whatever the
    order of rows is, so that their cells are others now."""
    axes, signs = rng.sample(range(3), 3), [rng.choice((1, -1)) for _ in range(2)]
    is_odd = sum(a > b for a, b in itertools.combinations(axes, 2)) % 2
    signs.append(math.prod(signs) * (-1 if is_odd else 1))
    opposite = lambda word: word[1:] if word.startswith("-") else "-" + word  # noqa: E731
    return [[row[axis] if sign > 0 else opposite(row[axis]) for axis, sign in zip(axes, signs)] for row in rows]


def triangulation_of(scan, certificate):
    """The triangulation as proof.py has it, which knows the spheres that several cells have in common."""
    found = proof.read_certificate(str(certificate), proof.Points(str(scan)))[0]
    found.cospherical = []
    if found.cells:
        found.check_cells()
    return found


def cells_in_random_order(t, rng):
    """Delaunay cells that are others where more than d+1 points are on a sphere. There, the first point in a random
    order is joined to the faces without it, and these are cut in the same way."""
    rank = {p: rng.random() for p in t.points.distinct}
    cells, is_seen = [], set()
    for start in range(len(t.cells)):
        cluster = [] if start in is_seen else [start]
        is_seen.add(start)
        faces = {}  # of the hull of the points on the sphere: facets of cells, by their plane
        for c in cluster:
            for i, (is_same, mate) in enumerate(zip(t.cospherical[c], t.mates[c])):
                if not is_same:
                    facet, side = t.facet(c, i)
                    normal = proof.cross(*t.edges(facet)) if t.dimension == 3 else ()
                    face = tuple(side * x // math.gcd(*normal) for x in normal) or facet
                    faces.setdefault(face, []).append(facet)
                elif mate[0] not in is_seen:
                    is_seen.add(mate[0])
                    cluster.append(mate[0])
        first = min((p for c in cluster for p in t.cells[c]), key=rank.get, default=None)
        for facets in faces.values():
            points = {p for facet in facets for p in facet}
            if first in points:
                continue
            second = min(points, key=rank.get)
            edges = collections.Counter(edge for facet in facets for edge in itertools.combinations(sorted(facet), 2))
            cells += ([(first, second, *edge) for edge, count in edges.items() if count == 1 and second not in edge]
                      if t.dimension == 3 else [(first, *facet) for facet in facets])
    rng.shuffle(cells)
    return cells


def prove_by_three_triangulations(name, rows, folder, rng):
    source, scan, other, text = (folder / file for file in ("drawn.xyz", "drawn.f64", "other.fcert", "cells.txt"))
    write_points(rows, source)
    if rows:
        scan = source
    else:  # which is no table
        source.write_text("# no points\n")
        scan.write_bytes(b"")
    certificate, records, exact_pairs = prove_whole(name, source, scan, folder)
    found = [certificate.read_bytes()]
    own = triangulation_of(scan, certificate)
    if rows and (IS_FULL or any(map(any, own.cospherical))):  # otherwise there is one triangulation alone
        write_points(turned(rows, rng), folder / "turned.xyz")
        compute(folder / "turned.xyz", folder / "turned.jsonl", other)
        head, _, rest = other.read_bytes().partition(b"sha256 ")
        own_hash = found[0].partition(b"sha256 ")[2][:64]
        other.write_bytes(head + b"sha256 " + own_hash + rest[64:])
        found.append(other.read_bytes())
        prove(f"{name}, turned", scan, other, records, exact_pairs)
        write_points(cells_in_random_order(own, rng), text)
        result = proof_py(scan, "--cells", text, "--from-cells", other)
        expect(result.returncode == 0, f"{name}: cells in a random order", result)
        found.append(other.read_bytes())
        prove(f"{name}, in a random order", scan, other, records, exact_pairs)
    told["inputs"] += 1
    told[f"with {len({frozenset(map(frozenset, decode(data))) for data in found})} triangulations"] += 1


# ---- What is wrong


def small_points(kind, rng):
    """Integers, most of them degenerate."""
    size = rng.randint(6, 30)
    if kind == 0:
        return [tuple(rng.randrange(2**20) for _ in range(3)) for _ in range(size)]
    if kind == 1:
        return list(itertools.product(range(rng.randint(2, 3)), range(rng.randint(2, 3)), range(rng.randint(2, 4))))
    if kind == 2:
        sphere = [p for p in itertools.product(range(-5, 6), repeat=3) if dot(p, p) == 26]
        return rng.sample(sphere, size) + [(0, 0, 0), (1, 0, 0)]
    if kind == 3:
        return [tuple(rng.randint(0, 3) for _ in range(3)) for _ in range(size)]
    if kind == 4:
        return [(a + b, a - b, 2 * a + 1) for a, b in (rng.choices(range(6), k=2) for _ in range(size))]
    return [(2 * a, 1 - a, 3 * a) for a in rng.sample(range(40), size)]


def refuse_corrupted(folder, rng):
    """Both checkers say the same of corrupted certificates; 0 and 1 are right by trying all points."""
    source, changed = folder / "small.xyz", folder / "changed.fcert"

    def certificate_of(points):
        write_points(points, folder / "made.xyz")
        compute(folder / "made.xyz", folder / "made.jsonl", folder / "made.fcert")
        return (folder / "made.fcert").read_bytes()

    count = 0
    while count < CORRUPTED:
        if count % 20 == 0:
            points = small_points(count // 20 % 6, rng)
            right = corrupted.Certified(points, rng, certificate_of)
            expect(is_delaunay(points, right.cells), "cells of a right certificate")
        kind = rng.choice((*corrupted.STRUCTURED, corrupted.double_cover) if count % 2 else corrupted.RANDOM)
        points, data = kind(rng) if kind == corrupted.double_cover else (right.points, kind(right))
        if data in (None, right.data):
            continue
        count += 1
        write_points(points, source)
        changed.write_bytes(data)
        ours, theirs = proof_program(source, changed), proof_py(source, changed)
        name = f"{kind.__name__} of {points}, {data}"
        expect(ours.returncode == theirs.returncode, name, ours, theirs)
        if ours.returncode < 2:
            cells = decode(data)
            is_right = cells is not None and is_delaunay(points, cells)
            expect(is_right == (ours.returncode == 0), f"{name}: it is {is_right}", ours)
        told[f"{kind.__name__}: {('proved', 'rejected', 'undecodable')[ours.returncode]}"] += 1
    expect(told["flip_on_a_sphere: proved"] > 0 or count < 200, "no flip of cells of one sphere was proved")


def refuse_forged(folder, rng):
    """Lists with a fault: neither checker proves them, and both say the same. Only proof.py compares hashes."""
    count, (scan, certificate, records) = 0, (folder / f"small.{end}" for end in ("xyz", "fcert", "jsonl"))
    while count < FORGED:
        points = small_points(count % 6, rng)
        points += rng.choices(points, k=rng.randint(0, 2))
        write_points(points, scan)
        compute(scan, records, certificate)
        right = records.read_text()
        head, _, rest = certificate.read_bytes().partition(b"sha256 ")
        certificate.write_bytes(head + b"sha256 " + (b"1" if rest[:1] == b"0" else b"0") + rest[1:])
        expect(proof_py(scan, certificate, records).returncode == 2, "a certificate with another hash is read")
        certificate.write_bytes(head + b"sha256 " + rest)
        for what, text in forged_lists.forged(right, rng):
            count += 1
            records.write_text(text)
            ours, theirs = proof_program(scan, certificate, records), proof_py(scan, certificate, records)
            if what == "input_sha256":
                expect(theirs.returncode == 1 and "input_sha256" in ours.stdout.split("not compared, ")[1],
                       "another hash", ours, theirs)
                continue
            expect(0 not in (ours.returncode, theirs.returncode), f"a list with another {what} is proved", ours, theirs)
            expect(ours.returncode == theirs.returncode, f"another {what}", ours, theirs)
    told["forged lists"] = count


def main():
    rng = random.Random(SEED)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        refuse_forged(folder, rng)
        refuse_corrupted(folder, rng)
        for name, rows in drawn_inputs(rng):
            before = len(failures)
            prove_by_three_triangulations(name, rows, folder, rng)
            if len(failures) > before:
                print("its files:", shutil.copytree(folder, tempfile.mkdtemp(), dirs_exist_ok=True))
        expect(told["inputs"] == DRAWN + LARGE, f"{told['inputs']} of {DRAWN + LARGE} inputs were drawn")
        expect(told["with 3 triangulations"] > 0, "points of a sphere get the same cells in any order")
        for source in [*sorted((ROOT / "fuzz/regressions").glob("*.xyz")),
                       *([BUNNY] if BUNNY.exists() else []), *paper_tables.kitten(folder)]:
            run(FLOWCERT, "points", source, "-o", folder / "points.f64")
            scan, is_small = folder / "points.f64", source.parent.name == "regressions"
            own = prove_whole(source.name, source, scan, folder, is_small)
            if is_small:
                prove_older_pairs(source.name, scan, *own)
    for what, count in sorted(told.items()):
        print(f"{count:7} {what}")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
