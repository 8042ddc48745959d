#!/usr/bin/env python3
"""proof_py_test.py

The tests of spec/proof.py that need no build: certificates and lists of cells with a fault each, which fail just the
condition that is named; texts that cannot be decoded; forged lists; and small inputs, most of them degenerate, with
triangulations and stationary points that are found here, by trying all sets of points.
The environment's PROOF is another folder of proof.py, one of a mutant.
"""
# CITES: FC-CERT-01 FC-CERT-02 FC-CERT-03 FC-CERT-04 FC-CERT-05 FC-FILE-48 FC-FILE-49 FC-FILE-50 FC-FILE-51
import contextlib
import hashlib
import io
import itertools
import json
import os
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

from certificate_bytes import certificate
from exact_delaunay import determinant, dot, minus

FOLDER = Path(os.environ.get("PROOF", str(Path(__file__).parents[2] / "spec")))
sys.dont_write_bytecode = True
sys.path.insert(0, str(FOLDER))
import proof  # noqa: E402

PENTAGON = [(1000, 0, 0), (309, 951, 0), (-809, 588, 0), (-809, -588, 0), (309, -951, 0)]  # symmetric to the x axis
SQUARE = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (2, 2, 0)]
HALVES = [(0, 1, 2), (1, 2, 3)]
KITE = [(-2, 0, 0), (0, 1, 0), (2, 0, 0), (0, -1, 0)]  # its short diagonal is Delaunay
BIPYRAMID = [(0, 0, 9), (0, 0, -9), (3, 0, 0), (-2, 3, 0), (-2, -3, 0)]
CORNERS = [(0, 0, 0), (30, 0, 0), (0, 30, 0), (0, 0, 30), (9, 9, 9)]  # the last one is inside, near the largest face
AROUND = [(1, 2, 3, 4), (0, 2, 3, 4), (0, 1, 3, 4), (0, 1, 2, 4)]


def text_of(points):
    return "".join("{!r} {!r} {!r}\n".format(*map(float, point)) for point in points).encode()


def rows(cells):
    return "".join(" ".join(map(str, cell)) + "\n" for cell in cells).encode()


def digest(points):
    data = b"".join(struct.pack("<3d", *(float(x) + 0.0 for x in point)) for point in points)
    return hashlib.sha256(data).hexdigest()


# ---- What is right, by trying all sets of points


def rank(vectors):
    """Of vectors in space, by Gram determinants."""
    return max((size for size in (1, 2, 3) for some in itertools.combinations(vectors, size)
                if determinant([[dot(a, b) for a in some] for b in some])), default=0)


def delaunay(points, rng):
    """A Delaunay triangulation: that of small random weights, which no d+2 points have on a common sphere."""
    names = [k for k, point in enumerate(points) if points.index(point) == k]
    dimension = rank([minus(points[k], points[0]) for k in names])
    axes = next(some for some in itertools.combinations(range(3), dimension) if rank(
        [[v if k in some else 0 for k, v in enumerate(minus(points[p], points[0]))] for p in names]) == dimension)
    lifted = {p: [points[p][k] for k in axes] + [dot(points[p], points[p]) * 2**1999 + rng.randrange(2**40)]
              for p in names}
    cells = []
    for cell in itertools.combinations(names, dimension + 1):
        start = lifted[cell[0]]
        edges = [minus(lifted[p], start) for p in cell[1:]]
        volume = determinant([edge[:-1] for edge in edges])
        if volume and dimension and all(determinant([*edges, minus(lifted[p], start)]) * volume > 0
                                        for p in names if p not in cell):
            cells.append(cell)
    return dimension, cells


def smallest_sphere(points):
    """Centre and squared radius of that through affinely independent points, and the centre's weights; or None."""
    edges = [minus(p, points[0]) for p in points[1:]]
    gram = [[2 * dot(a, b) for b in edges] for a in edges]
    whole = determinant(gram)
    if not whole:
        return None
    weights = [Fraction(determinant([row[:k] + [dot(a, a)] + row[k + 1:] for row, a in zip(gram, edges)]), whole)
               for k in range(len(edges))]
    center = [x + sum(w * edge[k] for w, edge in zip(weights, edges)) for k, x in enumerate(points[0])]
    return center, dot(minus(center, points[0]), minus(center, points[0])), [1 - sum(weights), *weights]


def stationary_points(points):
    """All of them: (index or kind, contact set, centre, squared distance), in order."""
    names = [k for k, point in enumerate(points) if points.index(point) == k]
    found = {}  # by contact set: centre, squared distance, and the points of all simplices with the centre inside
    for size in (1, 2, 3, 4):
        for some in itertools.combinations(names, size):
            sphere = smallest_sphere([points[p] for p in some])
            if sphere and min(sphere[2]) > 0:
                away = {p: dot(minus(points[p], sphere[0]), minus(points[p], sphere[0])) for p in names}
                if min(away.values()) == sphere[1]:
                    contact = tuple(p for p in names if away[p] == sphere[1])
                    found.setdefault(contact, (*sphere[:2], set()))[2].update(some)
    records = []
    for contact, (center, squared, inner) in found.items():
        of_face, of_hull = (rank([minus(points[p], points[contact[0]]) for p in some] if contact[0] in some else
                                 [minus(points[p], points[min(some)]) for p in some]) for some in (inner, set(contact)))
        records.append((of_hull if of_face == of_hull else [of_face, of_hull], contact, center, squared))
    return sorted(records, key=lambda one: ([[1, 2], [1, 3], [2, 3]].index(one[0]) + 4 if one[0] in (
        [1, 2], [1, 3], [2, 3]) else one[0], one[1]))


def nearest(x):
    try:
        return float(x)
    except OverflowError:
        return None


def list_of(points, centers="exact"):
    """As compute writes it: objects, to be forged before they are text."""
    records = stationary_points(points)
    names = [points.index(point) for point in points]
    members = [[k for k, name in enumerate(names) if name == one] for one in sorted(set(names))]
    kinds = [one[0] for one in records]
    head = {"format": "flowcert-stationary-points", "format_version": 1, "version": "0", "commit": "c", "kernel": "k",
            "compiler": "gcc", "cgal": "5", "input_sha256": digest(points), "points": len(points),
            "merged_duplicates": len(points) - len(members), "critical": [kinds.count(k) for k in range(4)],
            "regular_stationary": {f"{i}-{j}": kinds.count([i, j]) for i, j in ([1, 2], [1, 3], [2, 3])},
            "classes": [one for one in members if len(one) > 1]}
    lines = [head if centers == "exact" else {**head, "centers": centers}]
    for index, contact, center, squared in records:
        line = {"index": index, "kind": "regular" if isinstance(index, list) else "critical", "contact": list(contact)}
        if centers == "exact":
            line.update(center=[str(Fraction(x)) for x in center], squared_distance=str(Fraction(squared)))
        if centers != "none":
            line.update(center_double=[nearest(x) for x in center], squared_distance_double=nearest(squared))
        lines.append(line)
    return lines


def written(lines):
    return "".join((one if isinstance(one, str) else json.dumps(one, separators=(",", ":"))) + "\n"
                   for one in lines).encode()


# ---- The program


class ProofTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, data):
        path = self.folder / name
        path.write_bytes(data)
        return str(path)

    def run_proof(self, *arguments):
        out, err = io.TextIOWrapper(io.BytesIO(), "utf-8"), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), \
                unittest.mock.patch.object(sys, "argv", ["proof.py", *arguments]):
            try:
                status = proof.main()
            except SystemExit as ended:
                status = ended.code
        out.seek(0)
        told = out.read()
        self.assertEqual(err.getvalue().count("\n"), 1 if status == 2 else 0, err.getvalue())
        self.assertEqual(told.count("\n") if status else 1, 1 if status == 1 else 0 if status else 1, told)
        return status, told + err.getvalue()

    def scan(self, points):
        """The file of the points. Text without points cannot be decoded, so these are raw."""
        return self.file("p.xyz", text_of(points)) if points else self.file("p.f64", b"")

    def of_cells(self, points, cells, *more):
        return self.run_proof(self.scan(points), "--cells", self.file("c.txt", rows(cells)), *more)

    def of_certificate(self, points, data, *more):
        return self.run_proof(self.scan(points), self.file("p.fcert", data), *more)

    def expect(self, result, status, *parts):
        self.assertEqual(result[0], status, result[1])
        for part in parts:
            self.assertIn(part, result[1])

    # ---- Theorem 1

    def expect_only(self, condition, points, cells):
        self.expect_alone(condition, lambda: self.of_cells(points, cells))

    def expect_alone(self, condition, run):
        """What runs fails this condition, and no other one."""
        self.expect(run(), 1, f" rejected: {condition} ")
        reject = proof.Triangulation.reject

        def reject_others(self, failed, *why):
            if failed != condition:
                reject(self, failed, *why)

        with unittest.mock.patch.object(proof.Triangulation, "reject", reject_others):
            self.expect(run(), 0, "proved: ")

    def test_right_cells_are_proved_in_any_order_and_orientation(self):
        for points, cells in ((SQUARE, HALVES), (SQUARE, [(2, 3, 1), (0, 2, 1)]), (CORNERS, AROUND),
                              (KITE, [(0, 1, 3), (1, 2, 3)]), (BIPYRAMID, [(0, 2, 3, 4), (1, 2, 3, 4)]),
                              ([(3, 0, 0), (0, 0, 0), (1, 0, 0)], [(0, 2), (2, 1)]), ([(7, 7, 7)], []), ([], [])):
            self.expect(self.of_cells(points, cells), 0, f"these {len(cells)} cells are a Delaunay triangulation of "
                        f"{len(points)} points ({len(points)} different ones)")

    def test_flat_parts_of_the_hull_and_repeated_points_are_right(self):
        points = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (1, 2, 0), (1, -0.0, 0)]
        self.expect(self.of_cells(points, [(0, 1, 3), (4, 2, 3)]), 0, "of 5 points (4 different ones)")

    def test_T0_the_points_span_more_than_the_cells_or_less(self):
        for height in (1, -1):
            self.expect_only("T0", SQUARE[:3] + [(3, 3, height)], HALVES)
        self.expect(self.of_certificate([], certificate([], 0, 0, [])), 1, "T0 dimension 0")
        self.expect_only("T0", [(0, 0, 0), (1, 0, 0), (2, 1, 0)], [(0, 1), (1, 2)])
        self.expect(self.of_cells([(0, 0, 0), (1, 1, 1)], []), 1, "T0 dimension 0")
        self.expect(self.of_cells([(1, 1, 1), (1, 1, 1)], [(0, 1)]), 1, "T0 dimension 1")

    def test_T1_a_cell_is_flat_or_negative(self):
        self.expect(self.of_cells([*SQUARE, (1, 1, 0)], [(0, 1, 2), (1, 4, 2)]), 1, "T1 cell 1: its volume is 0")
        self.expect(self.of_cells([*SQUARE, (0, 0, 1)], [(0, 1, 2, 3)]), 1, "T1 cell 0")
        self.expect(self.of_cells([(0, 0, 0), (1, 0, 0), (3, 0, 0)], [(0, 1, 2)]), 1, "T1 cell 0")
        for names, status in (((0, 1, 2, 3), 0), ((1, 0, 2, 3), 1)):
            data = certificate(CORNERS[:4], 3, 1, [*names, 0, 0, 0, 0])
            self.expect(self.of_certificate(CORNERS[:4], data), status, "certificate rejected: T1 cell 0: its volume "
                        "is not positive, nothing is said of the list\n" if status else "proved: these 1 cells")
        flat = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
        self.expect(self.of_certificate(flat, certificate(flat, 3, 1, [0, 1, 2, 3, 0, 0, 0, 0])), 1, "T1 cell 0")

    def test_T1_alone(self):
        """A triangle folded over its neighbours, and a flat tetrahedron between two others."""
        for points, cells in (([(-2, 6, 0), (4, 2, 0), (-1, 0, 0), (-5, 3, 0)], [(0, 2, 3), (2, 0, 1), (1, 3, 2)]),
                              ([(3, 2, -3), (0, 2, -1), (4, 2, 1), (6, 2, -3), (-5, 5, -6)],
                               [(0, 1, 2, 4), (1, 0, 2, 3), (4, 2, 0, 3)])):
            found = proof.Triangulation(proof.Points(self.file("p.xyz", text_of(points))), len(cells[0]) - 1, "")
            found.cells = cells
            data = proof.encode(found)
            self.expect_alone("T1", lambda: self.of_certificate(points, data))

    def test_T2_a_third_cell_or_two_on_a_side(self):
        self.expect(self.of_cells([*SQUARE, (3, 3, 0)], [*HALVES, (1, 2, 4)]), 1, "T2 cell 2: a third cell")
        self.expect(self.of_cells(SQUARE, [(0, 1, 2), (0, 1, 3)]), 1, "T2 cell 1: on the same side")
        self.expect(self.of_cells(CORNERS, [*AROUND, AROUND[0]]), 1, "T2 cell 4")
        self.expect(self.of_cells([(0, 0, 0), (1, 0, 0), (3, 0, 0)], [(0, 1), (0, 2)]), 1, "T2 cell 1")

    def test_T2_of_certificates(self):
        points = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (5, 5, 0), (9, 9, 0)]
        halves = [0, 1, 2, 0, 0, 7]  # the triangles 0 1 2 and 3 2 1; the facet 2 3 of the second one comes next
        self.expect(self.of_certificate(points[:4], certificate(points[:4], 2, 2, [*halves, 0, 0])), 0)
        # In the plane the first cell says what is positive.
        self.expect(self.of_certificate(points[:4], certificate(points[:4], 2, 2, [1, 0, 2, 0, 7, 0, 0, 0])), 0)
        strip = [0, 2, 1, 0, 5, 0, 5, 0, 5, 0, 6]  # of Möbius: 0 2 1, and then with 0 1 and 4, 0 4 and 3, 3 4 and 2
        for numbers, words in (([*halves, 1], "T2 cell 2: a third cell at the facet, [1, 2], nothing is said of the"),
                               ([*halves, 2], "T2 cell 2: a second cell at a facet that was left unpaired, [0, 2]"),
                               ([*halves, 0, 4], "T2 cell 2: a second cell at a facet that was left unpaired, [0, 1]"),
                               ([0, 1, 1, 5], "T2 cell 1: on the same side of the facet [1, 1] as cell 0"),
                               (strip, "T2 cell 4: on the same side of the facet [1, 2] as cell 0")):
            self.expect(self.of_certificate(points, certificate(points, 2, 9, numbers)), 1, words)

    def test_T3_a_sphere_has_a_neighbour_inside(self):
        self.expect_only("T3", KITE, [(0, 1, 2), (0, 2, 3)])
        self.expect_only("T3", BIPYRAMID, [(0, 1, 2, 3), (0, 1, 3, 4), (0, 1, 2, 4)])

    def test_T4_is_implied_and_yet_named(self):
        line = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0)]
        self.expect(self.of_cells(line, [(0, 1), (2, 3)]), 1, "T4 cell 0: 4 facets")
        joined = [*CORNERS[:4], (0, -9, 0), (0, 0, -9)]
        self.expect(self.of_cells(joined, [(0, 1, 2, 3), (0, 1, 4, 5)]), 1, "T4 cell 0: 4 facets of the hull at [0, 1]")

    def test_T5_the_first_cell_does_not_see_all_of_the_hull(self):
        apart = [(0, 0, 0), (3, 0, 0), (0, 3, 0), (-9, 9, 0), (-8, 9, 0), (-9, 10, 0)]
        self.expect_only("T5", apart, [(0, 1, 2), (3, 4, 5)])
        touching = [(0, 0, 0), (3, 0, 0), (0, 3, 0), (2, 0.5, 0), (0, 1.5, 0), (-7, -8, 0)]  # the middle is on an edge
        self.expect(self.of_cells(touching, [(0, 2, 1), (3, 4, 5)]), 1, "T5 cell 1: the middle of cell 0 is not on")
        self.expect_only("T5", [*CORNERS[:4], (-9, 90, 9), (-8, 90, 9), (-9, 91, 9), (-9, 90, 10)],
                         [(0, 1, 2, 3), (4, 5, 6, 7)])

    def test_T6_the_hull_is_not_convex(self):
        self.expect_only("T6", [(0, 0, 0), (8, 0, 0), (0, 8, 0), (3, 3, 0)], [(0, 1, 3), (0, 2, 3)])
        self.expect_only("T6", CORNERS, AROUND[1:])

    def test_T7_a_double_cover_that_is_locally_right(self):
        pentagram = [(0, 1 + k, 1 + (k + 2) % 5) for k in range(5)]
        pentagram = pentagram[-1:] + pentagram[:-1]  # the first cell is symmetric to the x axis, and so is the ray
        self.assertEqual(pentagram[0], (0, 5, 2))
        self.expect_only("T7", [(0, 0, 0), *PENTAGON], pentagram)
        self.expect_only("T7", [(0, 0, 0), *PENTAGON], pentagram[1:] + pentagram[:1])
        for height in (1000, 3000):
            points = [(0, 0, 0), *PENTAGON, (0, 0, height), (0, 0, -height)]
            self.expect_only("T7", points, [(*cell, apex) for cell in pentagram for apex in (6, 7)])

    def test_T8_a_point_is_no_vertex(self):
        self.expect_only("T8", [*SQUARE, (1, 1, 0)], HALVES)
        self.expect_only("T8", CORNERS, [(0, 1, 2, 3)])
        self.expect_only("T8", [(0, 0, 0), (2, 0, 0), (1, 0, 0)], [(0, 1)])
        self.expect(self.of_cells([*SQUARE, (1, 1, 0)], HALVES), 1, "T8 point 4: no vertex of a cell")

    # ---- Certificates

    def test_a_certificate_from_cells_has_the_gluing_order(self):
        points = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (3, 3, 0)]
        out = str(self.folder / "out.fcert")
        self.expect(self.of_cells(points, [(0, 1, 2), (1, 3, 2)], "--from-cells", out), 0)
        expected = certificate(points, 2, 2, [0, 1, 2, 0, 0, 7, 0, 0], digest(points))
        self.assertEqual(Path(out).read_bytes(), expected)
        self.expect(self.of_certificate(points, expected), 0, "hash of the points: compared")
        self.expect(self.of_certificate(points, expected.replace(f"sha256 {digest(points)}\n".encode(), b"")), 0,
                    "no hash of the points")
        line = [(k, 0, 0) for k in range(300, 0, -1)]
        for first in (0, 128):  # a number of two bytes, the least one
            cells = [(k % 299, k % 299 + 1) for k in range(first, first + 299)]
            self.expect(self.of_cells(line, cells, "--from-cells", out), 0)
            self.expect(self.of_certificate(line, Path(out).read_bytes()), 0, "these 299 cells")
        far = [(0, 0, 0), *[(0, 0, 0)] * 200, (1, 0, 0), (3, 0, 0)]
        self.expect(self.of_cells(far, [(7, 201), (202, 201)], "--from-cells", out), 0)
        body = bytes([0, 201 % 128 + 128, 201 // 128, 0])  # then 0 is replaced by 202: a step of 202
        self.assertIn(body, Path(out).read_bytes())
        self.expect(self.of_certificate(far, Path(out).read_bytes()), 0, "of 203 points (3 different ones)")

    def test_nothing_is_written_of_wrong_cells(self):
        out = self.folder / "out.fcert"
        self.expect(self.of_cells(KITE, [(0, 1, 2), (0, 2, 3)], "--from-cells", str(out)), 1)
        self.assertFalse(out.exists())

    def test_what_cannot_be_decoded(self):
        points = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (3, 3, 0), (3, 3, 0)]
        numbers = [0, 1, 2, 0, 0, 7, 0, 0]
        good = certificate(points, 2, 2, numbers, digest(points))
        self.expect(self.of_certificate(points, good), 0)
        head, _, body = good.partition(b"\n\n")
        hashed = digest(points).encode()
        swapped = {"version": (b"certificate 1", b"certificate 2"), "word": (b"flowcert", b"flowCert"),
                   "CR": (b"\n", b"\r\n"), "blank": (b"points 5", b"points  5"), "zero": (b"points 5", b"points 05"),
                   "sign": (b"points 5", b"points +5"), "dimension": (b"dimension 2", b"dimension 4"),
                   "none": (b"dimension 2", b"dimension 0"), "empty": (b"cells 2", b"cells 0"),
                   "long": (b"cells 2", b"cells " + b"9" * 5000), "hash": (b"sha256 ", b"sha256 0"),
                   "key": (b"dimension", b"size"), "no line": (b"dimension 2\n", b""),
                   "capitals": (hashed, hashed.upper()), "bare": (b"sha256 " + hashed + b"\ndimension ", b""),
                   "no name": (b"flowcert-certificate 1\npoints ", b"")}
        broken = [good.replace(*one, 1) for one in swapped.values()]
        broken += [b"", b"\0", head, head + b"\n", head + b"\n\n", good + b"\0", good + b"\x80"]
        broken += [good[:k] for k in range(len(good))]
        broken += [head + b"\n\n" + bytes(some) for some in (
            [4, 1, 2], [9, 1, 2], [0, 1, 0x80, 0x80, 0x80, 0x80, 0x80, 0], [0, 1, 0xff, 0xff, 0xff, 0xff, 0x7f],
            [0, 1, 2, 0, 0, 9, 0, 0], [0, 1, 2, 10, 0, 0, 0, 0], [0, 1, 2, 0, 0, 7, 1, 1], [0, 1, 2, 0, 0, 0])]
        broken += [certificate(points, 2, count, numbers) for count in (1, 3, 10**17)]
        for data in broken:
            with self.subTest(data=data[:200]):
                self.expect(self.of_certificate(points, data), 2, "p.fcert: cannot be decoded: ")
        for data in (good.replace(b"points 5", b"points 6"), good.replace(hashed, b"0" * 64)):
            self.expect(self.of_certificate(points, data), 2, "p.fcert: not of these points")
        self.expect(self.of_certificate(points, certificate(points, 2, 2, [2**33])), 2, f"{2**33} is not the first row")
        self.expect(self.of_certificate(points, certificate(points, 2, 2, [2**33 + 1])), 2, "a number beyond 2^33")
        spelled = head + b"\n\n" + bytes([0x80, 0x80, 0x80, 0x80, 0x80, 0, *body[1:]])
        self.expect(self.of_certificate(points, spelled), 2, "of more than five bytes")
        spelled = head + b"\n\n" + bytes([0x80, 0x80, 0x80, 0x80, 0, *body[1:]])  # a long zero is a zero
        self.expect(self.of_certificate(points, spelled), 0)

    def test_files_and_usage(self):
        scan, cells = self.file("p.xyz", text_of(SQUARE)), self.file("c.txt", rows(HALVES))
        gone = str(self.folder / "gone")
        for arguments in ((scan, gone), (gone + ".xyz", cells), (scan, str(self.folder)), (str(self.folder), cells),
                          (scan, "--cells", gone), (scan, "--cells", cells, "--from-cells", gone + "/x"),
                          (cells, "--cells", cells)):
            self.expect(self.run_proof(*arguments), 2)
        for arguments in ([scan], [], [scan, cells, "--cells", cells], [scan, "x", "--from-cells", "y"]):
            ended = subprocess.run([sys.executable, str(FOLDER / "proof.py"), *arguments], capture_output=True)
            self.assertEqual((ended.returncode, b"Traceback" in ended.stderr), (2, False))
            self.assertIn(b"usage: ", ended.stderr)
        buffered = {key: value for key, value in os.environ.items() if key != "PYTHONUNBUFFERED"}
        for of_cells in (cells, self.file("one.txt", rows(HALVES[:1]))):  # which is right, and which is wrong
            with open("/dev/full", "w", encoding="ascii") as full:
                ended = subprocess.run([sys.executable, str(FOLDER / "proof.py"), scan, "--cells", of_cells],
                                       stdout=full, stderr=subprocess.PIPE, env=buffered)
            self.assertEqual((ended.returncode, b"Traceback" in ended.stderr), (2, False))
        with unittest.mock.patch.object(proof, "prove", side_effect=MemoryError):
            self.expect(self.run_proof(scan, "--cells", cells), 2, "there is not enough memory\n")

    def test_cells_that_cannot_be_read(self):
        for text in ("0 1 2\n1 2 4\n", "0 1 2\n1 2\n", "0 1 2\n\n", "0 1 2 3 0\n", "0\n", "a b c\n", "0 1 -2\n",
                     " 0 1 2\n", "0 1 2 \n", "0,1,2\n", "0 1 2.0\n", "0 1 99999999999\n", "0 1 \u0662\n", "0 1 2\r"):
            scan = self.file("p.xyz", text_of(SQUARE))
            self.expect(self.run_proof(scan, "--cells", self.file("c.txt", text.encode())), 2,
                        f"c.txt:{len(text.splitlines())}: ")  # the last line is wrong
        self.expect(self.run_proof(scan, "--cells", self.file("c.txt", b"0 1\t2\r\n03 1  2")), 0)

    def test_points_in_text_and_raw(self):
        cells = self.file("c.txt", rows(HALVES))
        same = {"p.xyz": b"0 0 0\n2 0 0\n0 2 0\n2 2 0", "q.xyz": b"-0 .0 0.\r\n2e0\t20e-1 \t -0\n0 2 0\n2 02.0e+0 0\n",
                "p.f64": b"".join(struct.pack("<3d", *p) for p in SQUARE)}
        same["q.xyz"] = same["q.xyz"].replace(b"20e-1", b"0e99")
        for name, data in same.items():
            self.expect(self.run_proof(self.file(name, data), "--cells", cells), 0, "proved")
        good = text_of(SQUARE)
        for bad in (b"1 2", b"1 2 3 4", b"", b" 1 2 3", b"1 2 3 ", b"# 1", b"1,2,3", b"+1 2 3", b"1 2 nan", b"1 2 inf",
                    b"1 2 1e999", b"1 2 .", b"1 2 -", b"1 2 1e", b"1 2 0x1", b"1 2 1d0", b"1 2 1E0", b"1 2 1_0",
                    "1 2 \u0663".encode(), b"1 2 3\r\r", b"1 2 3\0", b"\xff\xfe"):
            self.expect(self.run_proof(self.file("b.xyz", bad + b"\n" + good), "--cells", cells), 2, "b.xyz:1: ")
        self.expect(self.run_proof(self.file("b.xyz", b""), "--cells", cells), 2, "b.xyz:1: ")
        for end in (b"1 2 ", b"1 2 0\r", b"1 2 0 ", b"1 2 0\0"):
            self.expect(self.run_proof(self.file("b.xyz", good + end), "--cells", cells), 2, "b.xyz:5: ")
        raw = same["p.f64"]
        for of_cells in (cells, self.file("none.txt", b"")):
            self.expect(self.run_proof(self.file("p.raw", raw), "--cells", of_cells), 2, "p.raw: neither")
        for data, row in ((raw + b"\0", 5), (raw[:-8] + struct.pack("<d", float("inf")), 4), (b"\0", 1)):
            self.expect(self.run_proof(self.file("b.f64", data), "--cells", cells), 2, f"b.f64:{row}: ")

    # ---- Lists

    TRAPEZOID = [(0, 0, 0), (4, 0, 0), (0, 2, 0), (4, 2, 0), (0, 0, 5), (0, 0, 0), (9, 7, 11)]

    def right_case(self, points):
        cells = delaunay([tuple(map(Fraction, point)) for point in points], random.Random(7))[1]
        out = str(self.folder / "right.fcert")
        self.expect(self.of_cells(points, cells, "--from-cells", out), 0)
        return Path(out).read_bytes()

    def test_a_right_list_is_proved_and_said_to_be(self):
        data = self.right_case(self.TRAPEZOID)
        keys = {"exact": "index, kind, contact, center, squared_distance, center_double, squared_distance_double\n",
                "double": "index, kind, contact, center_double, squared_distance_double\n",
                "none": "index, kind, contact\n"}
        for centers, told in keys.items():
            some = list_of(self.TRAPEZOID, centers)
            self.expect(self.of_certificate(self.TRAPEZOID, data, self.file("l", written(some))), 0,
                        f"proved: all {len(some) - 1} stationary points: critical 6 ",
                        f"proved, line by line of {self.folder}/l: {told}",
                        f"proved, header of {self.folder}/l: points, "
                        "merged_duplicates, critical, regular_stationary, classes, input_sha256\n",
                        f"not compared, header of {self.folder}/l: version, commit, kernel, compiler, cgal\n",
                        "hash of the points: compared\n")
        head, *records = list_of(self.TRAPEZOID)
        more = {**dict(list(head.items())[:8]), "left_out": [3], **dict(list(head.items())[8:]), "morse_smale": True,
                "hull_volume": "1/3", "volumes": "exact"}
        self.expect(self.of_certificate(self.TRAPEZOID, data, self.file("l", written([more, *records]))), 0,
                    "not compared, header of", "cgal, left_out, morse_smale, hull_volume, volumes\n")
        respelled = written([head, *records]).replace(b"[0.0,0.0,0.0]", b"[0,-0.0,0E5]")
        self.expect(self.of_certificate(self.TRAPEZOID, data, self.file("l", respelled)), 0)

    def test_the_name_of_a_list_may_be_no_text(self):
        data, lines = self.right_case(self.TRAPEZOID), list_of(self.TRAPEZOID)
        name = os.fsdecode(b"l\xff")
        self.expect(self.of_certificate(self.TRAPEZOID, data, self.file(name, written(lines))), 0, "l\\udcff: index, ")

    def test_forged_values_are_refuted(self):
        data, lines = self.right_case(self.TRAPEZOID), list_of(self.TRAPEZOID)

        def refuted(forged, where, *words):
            text = written(forged)
            self.assertNotEqual(text, written(lines))
            self.expect(self.of_certificate(self.TRAPEZOID, data, self.file("l", text)), 1,
                        f"list refuted: line {where}: ", *words)

        head = lines[0]
        for key, value in (("format", "flowcert-pairs"), ("format_version", 2)):
            self.expect(self.of_certificate(self.TRAPEZOID, data,
                                            self.file("l", written([{**head, key: value}, *lines[1:]]))), 2, "l:1: ")
        for key, value in (("input_sha256", "0" * 64), ("points", 8), ("points", 77), ("merged_duplicates", 0),
                           ("classes", []), ("classes", [[0, 4]]), ("critical", [6, 0, 0, 0]),
                           ("critical", head["critical"][:3]), ("regular_stationary", {"1-2": 9, "1-3": 0, "2-3": 0})):
            refuted([{**head, key: value}, *lines[1:]], 1, key)
        for k, line in enumerate(lines[1:], 1):
            index = 5 if line["index"] != 5 else 4
            for key, value in (("index", index), ("index", [1, 2] if line["index"] != [1, 2] else [2, 3]),
                               ("kind", "regular" if line["kind"] == "critical" else "critical"), ("kind", "Critical"),
                               ("contact", line["contact"][:-1]), ("contact", [*line["contact"], 99]),
                               ("contact", line["contact"] * 2), ("center", [*line["center"][:2], "77"]),
                               ("center", [line["center"][0] + "/1", *line["center"][1:]]),
                               ("squared_distance", "1/77"), ("squared_distance", line["squared_distance"] + " "),
                               ("center_double", [*line["center_double"][:2], None]),
                               ("center_double", [line["center_double"][0] + 2e-15, *line["center_double"][1:]]),
                               ("squared_distance_double", None), ("squared_distance_double", 0.77)):
                if (key, value) != ("center_double", line["center_double"]):
                    refuted([*lines[:k], {**line, key: value}, *lines[k + 1:]], k + 1, key)
            refuted([*lines[:k], *lines[k + 1:]], k + 1)
            refuted([*lines[:k], line, *lines[k:]], k + 2)
            if k > 1:
                refuted([*lines[:k - 1], line, lines[k - 1], *lines[k + 1:]], k)
        refuted(lines[:1], 2, "missing")

    def test_another_form_of_a_list_cannot_be_decoded(self):
        data, lines = self.right_case(self.TRAPEZOID), list_of(self.TRAPEZOID)

        def undecodable(text, where, *words):
            self.expect(self.of_certificate(self.TRAPEZOID, data, self.file("l", text)), 2, f"l:{where}: ", *words)

        head, record = lines[:2]
        for forged in ({**record, "limits": [None, None]}, {**record, "samples": [0, 1]}, {**record, "volume": "0"}):
            key = list(forged)[-1]
            undecodable(written([head, forged, *lines[2:]]), 2, f'the key "{key}" is not proved')
        undecodable(written([{**head, "more": 1}, *lines[1:]]), 1, 'the key "more" is not proved')
        undecodable(written([{**head, "centers": "exact"}, *lines[1:]]), 1)
        undecodable(written([{**head, "centers": "exact"}, *list_of(self.TRAPEZOID, "double")[1:]]), 1)
        undecodable(written([{**head, "centers": "none"}, *lines[1:]]), 2)
        undecodable(written([dict(list(record.items())[::-1])]), 1)
        for lacks in head:
            text = written([{key: value for key, value in head.items() if key != lacks}, *lines[1:]])
            if f"{lacks}?" in proof.MADE_BY:  # another program may have made it
                self.expect(self.of_certificate(self.TRAPEZOID, data, self.file("l", text)), 0)
            else:
                undecodable(text, 1)
        for lacks in record:
            undecodable(written([head, {key: value for key, value in record.items() if key != lacks}, *lines[2:]]), 2)
        undecodable(written([head, dict(list(record.items())[::-1]), *lines[2:]]), 2)
        undecodable(json.dumps(head).encode() + b"\n" + written(lines[1:]), 1)
        good = json.dumps(record, separators=(",", ":"))
        for text in ("", "{}", "[]", "null", good[:-1], good + " ", good + ",", good.replace(":", ": ", 1), good + "\r",
                     good.replace('"index":0', '"index":00'), good.replace('"index":0', '"index":-0'),
                     good.replace('"index":0', '"index":0.0'), good.replace('"kind"', '"index":0,"kind"'),
                     good.replace('"contact":[0]', '"contact":[0,]'), good.replace("0.0", "NaN"),
                     good.replace("0.0", "Infinity"), good.replace("0.0", "+0.0"), good.replace("0.0", ".0"),
                     good.replace("0.0", "0.0x"), good.replace('["0"', "[0"), good.replace('"squared_', '"square_'),
                     good.replace('{"index"', '{,"index"'), good.replace(',"kind"', '"kind"'), "[" * 100000,
                     '{"' + "a" * 100000, "9" * 100000):
            undecodable(written([head, text, *lines[2:]]), 2)
        undecodable(b"", 1)
        undecodable(written(lines)[:-1], len(lines))
        undecodable(written(lines[:1]) + b"\xff\n", 2)
        undecodable(written(lines).replace(b'"commit":"c"', b'"commit":"\n"'), 1)
        undecodable(written(lines).replace(b'"commit":"c"', b'"commit":"\xfa"'), 1)

    def test_values_of_thousands_of_digits(self):
        large, small = 2**1000, Fraction(1, 2**1074)
        points = [(0, 0, 0), (9 * large, 10 * large, 3 * small), (9 * large, 5 * small, 11 * large),
                  (7 * small, 9 * large, 10 * large)]
        data, lines = self.right_case(points), list_of(points)
        self.assertGreater(max(line.get("squared_distance", "").find("/") for line in lines), 4300)
        self.expect(self.of_certificate(points, data, self.file("l", written(lines))), 0)

    def test_a_zero_has_no_sign(self):
        points = [(-5e-324, 0, 0), (-0.0, -0.0, 0)]
        data, lines = self.right_case(points), list_of([tuple(map(Fraction, point)) for point in points])
        for zero in (0.0, -0.0):
            lines[-1]["center_double"] = [zero, zero, 0.0]
            self.expect(self.of_certificate(points, data, self.file("l", written(lines))), 0)
        lines[-1]["center_double"] = [-5e-324, 0.0, 0.0]
        self.expect(self.of_certificate(points, data, self.file("l", written(lines))), 1, "center_double")

    def expect_by_many(self, points, record):
        """The list, which has this record, is proved by several triangulations. They are returned."""
        text, found = written(list_of(points)), []
        self.assertIn(record, text)
        for seed in range(8):
            found.append(delaunay(points, random.Random(seed))[1])
            out = str(self.folder / "out.fcert")
            self.expect(self.of_cells(points, found[-1], "--from-cells", out), 0)
            self.expect(self.of_certificate(points, Path(out).read_bytes(), self.file("l", text)), 0)
        return found

    def test_a_half_ball_is_regular_by_any_diagonal(self):
        points = [(3, 0, 0), (-3, 0, 0), (0, 3, 0), (0, -3, 0), (1, 2, 2), (-2, -1, 2), (0, 0, 3)]
        found = self.expect_by_many(points, b'"index":[2,3],"kind":"regular","contact":[0,1,2,3,4,5,6]')
        self.assertEqual({any({0, 1} <= set(cell) for cell in cells) for cells in found}, {False, True})

    def test_a_ball_has_index_3_by_its_middle_triangle_or_its_axis(self):
        points = [(5, 0, 0), (-3, 4, 0), (-3, -4, 0), (0, 0, 5), (0, 0, -5)]
        found = self.expect_by_many(points, b'"index":3,"kind":"critical","contact":[0,1,2,3,4]')
        self.assertEqual(set(map(len, found)), {2, 3})

    def test_a_circle_of_two_cells_whose_centre_is_in_a_triangle(self):
        points = [(5, 0, 0), (-3, 4, 0), (-4, -3, 0), (0, -5, 0), (0, 0, 7)]
        found = self.expect_by_many(points, b'"index":2,"kind":"critical","contact":[0,1,2,3]')
        self.assertIn(True, {any({0, 2} <= set(cell) for cell in cells) for cells in found})

    def test_a_double_beyond_all_is_null(self):
        points = [(0, 0, 0), (2**600, 0, 0), (0, 2**601, 0)]
        data, lines = self.right_case(points), list_of(points)
        self.assertIsNone(lines[-1]["squared_distance_double"])
        self.expect(self.of_certificate(points, data, self.file("l", written(lines))), 0)
        text = written(lines).replace(b'distance_double":null', b'distance_double":1e999')
        self.expect(self.of_certificate(points, data, self.file("l", text)), 1, "squared_distance_double")

    # ---- Drawn inputs

    def test_drawn_inputs_against_all_sets_of_points(self):
        rng, kinds, dimensions = random.Random(45), set(), set()
        grid = list(itertools.product(range(3), repeat=2))
        sphere = [p for p in itertools.product(range(-3, 4), repeat=3) if dot(p, p) == 9]
        for run in range(120):
            size = rng.randint(1, 8)
            points = [[(rng.randint(0, 2), rng.randint(0, 2), rng.randint(0, 1)) for _ in range(size)],
                      [(rng.randint(0, 3), rng.randint(0, 3), 5) for _ in range(size)],
                      [(2 * k, 1 - k, 3 * k) for k in rng.choices(range(6), k=size)],
                      [*rng.sample(sphere[len(sphere) * (run % 12 > 6) // 2:], size), (0, 0, 0)],
                      [tuple(rng.randint(-50, 50) for _ in range(3)) for _ in range(size)],
                      [(a + b, a - b, 2 * a + 1) for a, b in rng.choices(grid, k=size)]][run % 6]
            scale = rng.choice([1, Fraction(1, 2), Fraction(3, 1024)])
            points = [tuple(scale * x for x in point) for point in points]
            dimension, cells = delaunay(points, rng)
            rng.shuffle(cells)
            out = str(self.folder / "out.fcert")
            self.expect(self.of_cells(points, [rng.sample(cell, len(cell)) for cell in cells], "--from-cells", out), 0)
            data, lines = Path(out).read_bytes(), list_of(points, rng.choice(["exact", "double", "none"]))
            self.assertEqual(re.search(rb"dimension (\d)\ncells (\d+)", data).groups(),
                             (b"%d" % dimension, b"%d" % len(cells)))
            self.expect(self.of_certificate(points, data, self.file("l", written(lines))), 0)
            kinds.update(str(line["index"]) for line in lines[1:])
            dimensions.add(dimension)
            if len(cells) > 1:
                wrong = rng.randrange(len(cells))
                self.expect(self.of_cells(points, cells[:wrong] + cells[wrong + 1:]), 1, "cells rejected: T")
                self.damage(points, data, cells, rng)
        self.assertEqual(kinds, {"0", "1", "2", "3", "[1, 2]", "[1, 3]", "[2, 3]"})
        self.assertEqual(dimensions, {0, 1, 2, 3})

    def damage(self, points, data, cells, rng):
        """A certificate with another byte is refused, but for one that says the same or another right thing."""
        start = data.index(b"\n\n") + 2
        for _ in range(4):
            place = rng.randrange(start, len(data))
            other = rng.choice([0, 1, 2, data[place] ^ 1 << rng.randrange(8)])
            status, told = self.of_certificate(points, data[:place] + bytes([other]) + data[place + 1:])
            if status == 0:
                read = proof.Points(str(self.folder / "p.xyz"))
                found, _ = proof.read_certificate(str(self.folder / "p.fcert"), read)
                self.assertEqual(len(found.cells), len(cells), told)
                for cell in found.cells:
                    sphere = smallest_sphere([points[p] for p in cell])
                    self.assertTrue(all(dot(minus(p, sphere[0]), minus(p, sphere[0])) >= sphere[1] for p in points))


if __name__ == "__main__":
    unittest.main()
