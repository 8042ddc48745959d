#!/usr/bin/env python3
"""proof_witnesses_test.py FLOWCERT_PROOF

Every input of proof_py_test.py is one of flowcert-proof, too: as a certificate, and with the same verdict, the same
condition where one alone fails, and the same line of a list. Further inputs, for both checkers: what doubles cannot
tell at 2^-500, at 2^450, with subnormals, and by an ulp; small clusters beside far points; cells that are right for
other points; and persistence pairs, found here by reducing the whole boundary matrix in fractions.
tests/mutants/proof.py runs these inputs on faulty programs.
"""
# CITES: FC-CERT-02 FC-CERT-03 FC-CERT-04 FC-CERT-05 FC-CERT-06 FC-FILE-49 FC-FILE-50 FC-FILE-51
import itertools
import json
import random
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from fractions import Fraction
from pathlib import Path

import proof_py_test
from proof_py_test import delaunay, dot, list_of, minus, proof, smallest_sphere, written

CASES = []  # of the program: its arguments, the statuses that are right, and what it has to print, wherever
FULL = "standard output cannot be written"  # what it has to print where nothing can be


def fault_of(program, case):
    """What is wrong with the program's answer to a case, or None."""
    arguments, statuses, words = case
    try:
        with open("/dev/full", "wb") as full:
            result = subprocess.run([program, *arguments], stdout=full if FULL in words else subprocess.PIPE,
                                    stderr=subprocess.PIPE, timeout=20)
    except subprocess.TimeoutExpired:
        return "no answer"
    told = ((result.stdout or b"") + result.stderr).decode(errors="backslashreplace")
    if result.returncode in statuses and all(part in told for part in words):
        return None
    return f"{' '.join(arguments)}: not {statuses} {words}, but {result.returncode} {told[:400]}"


def pairs_of(points, cells):
    """Persistence pairs of positive length: dimension, birth and death, which may be None. Of the alpha filtration."""
    names = [k for k, point in enumerate(points) if points.index(point) == k]
    faces = {face for cell in [*cells, *((p,) for p in names)] for size in range(1, len(cell) + 1)
             for face in itertools.combinations(sorted(cell), size)}
    values = {}
    for face in sorted(faces, key=len, reverse=True):
        center, squared, _ = smallest_sphere([points[p] for p in face])
        is_empty = all(dot(minus(points[p], center), minus(points[p], center)) >= squared for p in names)
        values[face] = squared if is_empty else min(values[one] for one in values if set(face) < set(one))
    order = sorted(faces, key=lambda face: (values[face], len(face)))
    columns, pairs, unpaired = {}, [], set()
    for face in order:
        column = {face[:k] + face[k + 1:] for k in range(len(face))} if len(face) > 1 else set()
        while column:
            last = max(column, key=order.index)
            if last not in columns:
                columns[last] = column
                unpaired.remove(last)
                pairs += [(len(last) - 1, values[last], values[face])] if values[last] != values[face] else []
                break
            column = column ^ columns[last]
        else:
            unpaired.add(face)
    return sorted(pairs) + [(len(face) - 1, values[face], None) for face in unpaired]


class WitnessTest(proof_py_test.ProofTest):
    kept = None  # where the files of cases are
    alone = None  # the condition that fails alone

    is_damaged = False  # by chance, so that it may have several faults

    def keep(self, arguments, statuses, *words):
        files = []
        for argument in arguments:
            path = Path(argument)
            if path.is_file():
                path = self.kept / f"{len(CASES)}-{len(files)}-{path.name}"
                path.write_bytes(Path(argument).read_bytes())
            files.append(argument if argument == "--pairs" else str(path))
        CASES.append((files, statuses, words))

    def run_proof(self, *arguments):
        result = super().run_proof(*arguments)
        if self.alone and result[0] == 0:  # where this condition was not asked
            return result
        if "--cells" not in arguments:
            self.keep_certificate(arguments, *result)
        elif result[0] == 2 and (row := re.match(r".*/(b\.(?:xyz|f64):[0-9]+: )", result[1])):
            is_of_row = row[1].startswith("b.xyz") and Path(arguments[0]).stat().st_size > 0
            self.keep((arguments[0], self.file("any.fcert", b"")), {2}, row[1] if is_of_row else "b.")
        elif result[0] < 2 and (data := self.glued(*arguments[:3:2])) is not None:
            certificate = (arguments[0], self.file("glued.fcert", data))
            status, told = super().run_proof(*certificate)
            if status < 2:  # cells that are not connected are no certificate
                self.assertEqual(status, result[0], told)
                self.keep_certificate(certificate, status, told)
        return result

    def glued(self, scan, cells):
        """The certificate of cells that may be wrong, or None if there is none."""
        def reject(_, condition, *why):
            if condition not in ("T0", "T8"):
                raise proof.Rejected(condition)

        try:
            with unittest.mock.patch.object(proof.Triangulation, "reject", reject):
                return proof.encode(proof.read_cells(cells, proof.Points(scan)))
        except (proof.Rejected, proof.Undecodable):
            return None

    def keep_certificate(self, arguments, status, told):
        """The program is held to what proof.py told. It does not compare hashes, tells from the number of cells that
        bytes are missing, before it looks at T2, reads headers of lists otherwise, and decimals with e alone."""
        data, text = (Path(one).read_bytes() if Path(one).is_file() else b"" for one in (*arguments[1:], "")[:2])
        if status and "sha256" in told or b"cells 9\n" in data or b"0E5" in text:
            return
        if status == 0 and "morse_smale" in told:
            self.keep(arguments, {2})
        elif status == 0:
            self.keep(arguments, {0}, *told.split("\n")[:2])
        elif self.alone:
            self.keep(arguments, {1}, f"certificate rejected: {self.alone} ")
        elif self.is_damaged:
            self.keep(arguments, {1, 2})
        elif status == 2 and (not text or "is not proved" in told):
            self.keep(arguments, {2})
        elif status == 2 and b'"commit":"c"' in text:
            self.keep(arguments, {2} if b"NaN" in text else {1, 2}, *["a number is due"] if b"NaN" in text else [])
        elif status == 1:
            self.keep(arguments, {1}, re.match("certificate rejected: T|list refuted: line [0-9]+: ", told).group())

    def expect_alone(self, condition, run):
        self.alone = condition
        super().expect_alone(condition, run)
        self.alone = None


    def damage(self, *arguments):
        self.is_damaged = True
        super().damage(*arguments)
        self.is_damaged = False

    # ---- Conditions

    def test_T2_of_certificates_with_as_many_cells_as_they_say(self):
        points = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (5, 5, 0), (9, 9, 0)]
        halves, strip = [0, 1, 2, 0, 0, 7], [0, 2, 1, 0, 5, 0, 5, 0, 5, 0, 6]
        for numbers, words in (([*halves, 1, 0], "T2 cell 2 is the third one"),
                               ([*halves, 2, 0], "T2 cell 2 is the second one at a facet that was left"),
                               ([*halves, 0, 4], "T2 cell 2 is the second one at a facet that was left"),
                               (strip, "T2 cell 4 is on another one's side")):
            data = proof_py_test.certificate(points, 2, 5 if numbers is strip else 3, numbers)
            self.expect(self.of_certificate(points, data), 1, "T2")
            self.keep((str(self.folder / "p.xyz"), str(self.folder / "p.fcert")), {1}, words)

    def test_T5_alone_in_connected_cells(self):
        """Two turns around the point 0. The first cell lies beyond the inner turn."""
        points = [(0, 0, 0), (83, 19, 0), (21, 78, 0), (-55, 39, 0), (-44, -29, 0), (-28, -39, 0), (34, 0, 0),
                  (-23, 41, 0), (-3, -78, 0), (25, -77, 0), (-34, -8, 0), (9, -7, 0), (-10, -6, 0)]
        cells = [(0, 3, 10), (10, 4, 5), (0, 1, 2), (5, 0, 10), (6, 0, 11), (12, 8, 9), (7, 8, 12), (5, 6, 11),
                 (0, 7, 12), (3, 4, 10), (0, 9, 1), (0, 2, 3), (0, 5, 11), (9, 0, 12), (0, 6, 7)]
        self.expect_only("T5", points, cells)

    def test_a_circle_whose_cells_are_numbered_inwards(self):
        """Three cells on the circle, which the first cell is not, come before the one between them."""
        points = [(-3, 9, 0), (4, 3, 0), (0, 5, 0), (5, 0, 0), (-5, 0, 0), (3, -4, 0), (-4, 3, 0), (-4, -5, 0),
                  (-4, -3, 0), (-3, -4, 0)]
        cells = [(1, 2, 6), (4, 7, 8), (0, 2, 6), (4, 6, 8), (0, 1, 2), (1, 3, 5), (0, 4, 6), (7, 8, 9), (5, 7, 9),
                 (1, 5, 6), (6, 8, 9), (5, 6, 9)]
        self.assertEqual(self.prove(points, cells, 0, "text"), 0)

    def test_cells_that_are_announced_and_not_there(self):
        """No memory is taken for them."""
        data = proof_py_test.certificate(proof_py_test.SQUARE, 2, 10**6, [0, 1, 2, 0, 0, 0])
        self.of_certificate(proof_py_test.SQUARE, data)
        self.keep((str(self.folder / "p.xyz"), str(self.folder / "p.fcert")), {2}, "it says too many cells")

    def test_usage(self):
        scan = self.scan(proof_py_test.SQUARE)
        for arguments in ((), (scan,), (scan, scan, scan, scan), (scan, scan, "--pairs"), (scan, scan, "-x")):
            self.keep(arguments, {2}, "usage: ")
        self.keep(("--help",), {0}, "usage: ", "--pairs P", "--version", "Exit status: 0")
        self.keep(("--version",), {0}, "flowcert-proof ")
        self.keep(("--help",), {2}, FULL)
        out = str(self.folder / "out.fcert")
        self.expect(self.of_cells(proof_py_test.SQUARE, proof_py_test.HALVES, "--from-cells", out), 0)
        self.keep((scan, out), {2}, FULL)

    # ---- Numbers

    def prove(self, points, cells, scale, kind):
        """The list of points, which are integers here, times 2^scale."""
        exact = [tuple(Fraction(x) * Fraction(2)**scale for x in point) for point in points]
        self.assertTrue(all(float(x) == x for point in exact for x in point))
        data = b"".join(struct.pack("<3d", *map(float, point)) for point in exact)
        scan = self.file("p.f64", data) if kind == "raw" else self.file("p.xyz", proof_py_test.text_of(exact))
        out = str(self.folder / "out.fcert")
        text = self.file("c.txt", proof_py_test.rows(cells))
        result = self.run_proof(scan, "--cells", text, "--from-cells", out)
        if result[0] == 0:
            records = self.file("l", written(list_of(exact)))
            self.expect(self.run_proof(scan, out, records), 0)
            if max(abs(x) for point in exact for x in point) < 2**500:
                self.keep_pairs(scan, out, records, exact, cells)
                self.keep_exact_pairs(scan, out, exact, cells)
        return result[0]

    def keep_pairs(self, scan, certificate, records, exact, cells):
        pairs = pairs_of(exact, cells)
        lines = [f"{dimension} {float(birth)!r} {'inf' if death is None else repr(float(death))}"
                 for dimension, birth, death in pairs]
        told = f"proved: all {len(pairs)} pairs, dimensions 0 to 2, as nearest doubles"
        endless = [line.replace("inf", "1e300") for line in lines]
        refused = "not a dimension, a birth and a death"
        variants = (
            (["# a comment", *lines[::-1]], 0, told), ([*lines, lines[-1]], 1, "pairs refuted"),
            (lines[1:], 1, "pairs refuted"), (endless, 1, "pairs refuted"), ([*lines, "x 0 1"], 2, refused),
            ([lines[0].replace(" ", "\t"), *lines[1:]], 2, refused), ([lines[0] + "x", *lines[1:]], 2, refused),
            ([lines[0][::-1].replace(" ", ";", 1)[::-1], *lines[1:]], 2, refused),
            ([line.replace("inf", "1e999") for line in lines], 2, refused),
            (["# flowcert: plain values, not squared", *lines], 2, "not squared"),
            (["# With regular stationary points, as pairs of length zero.", *lines], 2, "length zero"))
        for text, status, words in variants if len(exact) == 5 else variants[:4]:  # enough of them, which take time
            file = self.file("p.pers", "".join(f"{line}\n" for line in text).encode())
            self.keep((scan, certificate, "--pairs", file), {status}, words)

    def test_values_beyond_the_doubles_are_no_infinity(self):
        points = [(0, 0, 0), (2**600, 0, 0)]
        out = str(self.folder / "out.fcert")
        self.expect(self.of_cells(points, [(0, 1)], "--from-cells", out), 0)
        pairs = self.file("p.pers", b"0 0.0 inf\n" * 2)
        self.keep((str(self.folder / "p.xyz"), out, "--pairs", pairs), {2}, "is beyond the doubles")

    def test_no_points_have_no_pairs(self):
        self.of_certificate([], proof_py_test.certificate([], -1, 0, []))
        files = (str(self.folder / "p.f64"), str(self.folder / "p.fcert"))
        self.keep((*files, "--pairs", self.file("p.pers", b"")), {0}, "proved: all 0 pairs")

    def keep_exact_pairs(self, scan, certificate, exact, cells):
        """As persistence --json writes them. Each end is some critical point of its index and value."""
        head, *lines = list_of(exact)
        points = {}
        for k, line in enumerate(lines):
            order = ("contact", "center", "center_double", "squared_distance", "squared_distance_double")
            fields = {"record": k, **{key: line[key] for key in order}}
            points.setdefault((str(line["index"]), line["squared_distance"]), []).append(fields)
        pairs = [{"dimension": dimension, "birth": points[str(dimension), str(birth)].pop(),
                  "death": None if death is None else points[str(dimension + 1), str(death)].pop()}
                 for dimension, birth, death in pairs_of(exact, cells)]
        kept = ("version", "commit", "kernel", "compiler", "cgal", "input_sha256", "points", "merged_duplicates",
                "critical", "regular_stationary")
        header = {"format": "flowcert-persistence", "format_version": 1, **{key: head[key] for key in kept},
                  "seconds": {"delaunay": [0.5, {"all": None}]}, "has_zero": False}
        first, count = pairs[0], len(pairs)

        def forged(end="birth", **fields):
            return {"pairs": [{**first, end: {**first[end], **fields}}, *pairs[1:]]}

        changes = (
            ({}, 0, f"proved: all {count} pairs, dimensions 0 to 2, exactly"), ({"pairs": pairs[1:]}, 1, "refuted"),
            ({"pairs": [*pairs, pairs[0]]}, 1, "is in another pair, too"),
            ({"pairs": [{**one, "death": None} for one in pairs]}, 1 if count > 1 else 0, "pairs "),
            ({"pairs": [{**first, "dimension": 3}, *pairs[1:]]}, 1, "there is no pair of dimension 3"),
            ({"pairs": [{**first, "dimension": 1}, *pairs[1:]]}, 1, "has another index"),
            (forged(record=len(lines)), 1, "there is no record"),
            (forged(record=float(first["birth"]["record"])), 1, "there is no record"),
            (forged(center=["0", "0", "1/7"]), 1, "center"),
            (forged(more=0), 2, "cannot be decoded"), ({"more": 0}, 2, ""), ({"has_zero": True}, 2, "length zero"),
            ({"points": len(exact) + 1}, 1, "points"), ({"format": "flowcert-stationary-points"}, 2, ""))
        for change, status, words in changes if len(exact) == 5 else changes[:1]:  # enough of them, which take time
            text = written([{**header, "pairs": pairs, **change}])
            self.keep((scan, certificate, "--pairs", self.file("p.json", text)), {status}, words)
        text = written([{**header, "pairs": pairs}])
        for other in () if len(exact) != 5 else (
                text + b"{}\n", text.replace(b'"has_zero":false', b'"has_zero":null'), text[:-2] + b",\n",
                text.replace(b'},"death"', b'}"death"', 1),
                text.replace(b'"commit":"c"', b'"commit":"c\\n"')):
            self.keep((scan, certificate, "--pairs", self.file("p.json", other)), {2}, "cannot be decoded")

    def test_what_doubles_cannot_tell_in_18_bits(self):
        """The determinant is 1 in a sum of products of 2^50. Spheres of a cube are equal, of numbers of 130 bits."""
        rows = [(0, 0, 0), (-90774, -57293, 72024), (-114104, -72018, 90535), (-118103, -74542, 93708)]
        self.assertEqual(abs(proof_py_test.determinant(rows[1:])), 1)
        self.assertEqual(self.prove(rows, [(0, 1, 2, 3)], 0, "text"), 0)
        cube = [tuple(999 * x for x in corner) for corner in itertools.product((0, 1), repeat=3)]
        self.assertEqual(self.prove(cube, delaunay(cube, random.Random(3))[1], 0, "text"), 0)

    def test_drawn_inputs_at_many_scales(self):
        rng = random.Random(453)
        sphere = [p for p in itertools.product(range(-3, 4), repeat=3) if dot(p, p) == 9]
        circle = [(x, y, 0) for x, y, z in itertools.product(range(-5, 6), range(-5, 6), (0,)) if x * x + y * y == 25]
        statuses = []
        for run in range(150):
            base = [rng.sample(sphere, rng.randint(4, 7)), rng.sample(circle, rng.randint(3, 7)),
                    list(itertools.product((0, 1), repeat=3)),
                    [tuple(rng.randint(-3, 3) for _ in range(3)) for _ in range(6)]][run % 4]
            if run % 3:
                base += [(0, 0, 0)]
            axes, signs = rng.sample(range(3), 3), rng.choices((1, -1), k=3)
            base = [tuple(signs[k] * point[axes[k]] for k in range(3)) for point in base]
            bits, scale = rng.choice([(0, 0), (0, -500), (0, 450), (0, -1074), (50, -50), (50, -550), (50, 400),
                                      (40, -1074), (13, 0), (21, 0)])
            points = [tuple((x << bits) + (rng.randint(-1, 1) if bits and x else 0) for x in point) for point in base]
            if run % 5 == 4:  # a cluster beside a far point
                far = rng.choice((60, 120, 180, 215, 270))
                bits, scale, points = 0, rng.choice((-far, -far - 500)), [*base, (2**far, 2**far, 0)]
            cells = delaunay(points if rng.random() < 0.5 or len(points) != len(base) else base, rng)[1]
            statuses.append(self.prove(points, cells, scale, rng.choice(("raw", "text"))))
        self.assertGreater(statuses.count(0), 60)
        self.assertGreater(statuses.count(1), 5)


def main():
    program = sys.argv[1]
    sys.argv[1:] = []
    with tempfile.TemporaryDirectory() as folder:
        WitnessTest.kept = Path(folder)
        result = unittest.main(exit=False, argv=sys.argv[:1]).result
        faults = [fault for case in CASES if (fault := fault_of(program, case))]
        print("\n".join(faults))
        print(f"{len(CASES)} inputs of the program, {len(faults)} of them with another answer")
    return 0 if result.wasSuccessful() and not faults else 1


if __name__ == "__main__":
    sys.exit(main())
