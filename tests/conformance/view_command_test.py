#!/usr/bin/env python3
"""The data of viewer pages, against what the other commands say of the same input.

usage: view_command_test.py FLOWCERT

Guarantees: every blob is decoded as src/cli/manual/view.md says, and contact sets, indices, limits of orbits, pairs and
triangles are compared exactly. Positions are compared within the rounding that the format names. Exit status: 0; 1
where something differs.
"""
import base64
import collections
import fractions
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

NONE = 0xFFFFFFFF
FLOWCERT = None
LETTERS = {"f64": "d", "f32": "f", "u32": "I", "u8": "B"}
# A program that is wrong on every input.
CLAIMS_A_SADDLE = "test -f {in} && printf 'index,x,y,z\\n1,0,0,0\\n' > {out}"
OPENING = '<script type="application/json" id="flowcert-data">'

# Inputs with every kind of point: a pyramid, a cube, a square with a point above, a half octahedron, collinear points,
# repeated rows, one point, and points of very different and of extreme sizes.
INPUTS = {
    "pyramid": "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n",
    "cube": "".join(f"{x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1)),
    "half-octahedron": "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n",
    "kind-1-2": "-5 0 0\n5 0 0\n3 4 0\n-3 4 0\n",
    "line": "0 0 0\n1 0 0\n3 0 0\n",
    "repeated": "1 1 1\n0 0 0\n1 1 1\n4 0 0\n0 4 0\n0 0 4\n",
    "one": "1 2 3\n",
    "flows-to-a-saddle": "0 5 0\n-3 0 -2\n3 0 -2\n0 0 12\n0 -5 0\n",
    "kind-1-3": "0 0 0\n1 0 0\n1 1 0\n1 1 1\n2 1 1\n",
    "huge": "1e300 0 0\n-1e300 0 0\n0 1.5e300 0\n0 1 2e300\n0 0 -7e299\n",
    "tiny": "1e-300 0 0\n-1e-300 0 0\n0 1.5e-300 0\n0 1e-301 2e-300\n0 0 -7e-301\n",
    "scattered": "".join(f"{i * 37 % 101} {i * 61 % 97} {i * 53 % 89}\n" for i in range(60)),
}


CAGE = pathlib.Path(__file__).resolve().parents[1] / "inputs" / "cage.xyz"


def run(*words, text="", status=0):
    done = subprocess.run([FLOWCERT, *map(str, words)], input=text.encode(), capture_output=True, check=False)
    if done.returncode != status:
        raise AssertionError(f"{words}: exit status {done.returncode}: {done.stderr.decode()}")
    return done.stdout.decode()


def numbers(blob):
    letter = LETTERS[blob["type"]]
    if blob["data"] == "":
        assert blob["count"] == 0
        return []
    planes = zlib.decompress(base64.b64decode(blob["data"], validate=True))
    size = struct.calcsize("<" + letter)
    assert len(planes) == size * blob["count"]
    rows = b"".join(planes[i:: blob["count"]] for i in range(blob["count"]))
    return list(struct.unpack(f"<{blob['count']}{letter}", rows))


def data_of(page):
    assert page.count(OPENING) == 1
    begin = page.index(OPENING) + len(OPENING)
    text = page[begin: page.index("</script>", begin)]
    assert "<" not in text
    return json.loads(text)


def decoded(value):
    if isinstance(value, dict):
        if set(value) == {"type", "count", "data"}:
            return numbers(value)
        return {key: decoded(part) for key, part in value.items()}
    return value


def view(text, *options, status=0):
    return decoded(data_of(run("view", "-", "-o", "-", *options, text=text, status=status)))


def triples(flat):
    return [tuple(flat[i: i + 3]) for i in range(0, len(flat), 3)]


def determinant(a, b, c):
    return sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))


def polygon_area(corners):
    twice = [0.0, 0.0, 0.0]
    for b, c in zip(corners[1:], corners[2:]):
        u, v = ([x - y for x, y in zip(end, corners[0])] for end in (b, c))
        for i in range(3):
            twice[i] += u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]
    return math.hypot(*twice) / 2


def slices(offsets, flat):
    return [flat[a:b] for a, b in zip(offsets, offsets[1:])]


def mod_2(offsets, flat, steps):
    """What an odd number of these lists has."""
    found = set()
    for step in steps:
        found ^= set(flat[offsets[step]: offsets[step + 1]])
    return found


class Page:
    """What a page says, in the words of the other commands."""

    def __init__(self, data):
        self.data = data
        records = data["records"]
        self.samples = triples(data["samples"])
        self.contacts = slices(records["contact_offsets"], records["contacts"])
        rows = data["sample_rows"]
        self.names = [[rows[s] for s in contact] for contact in self.contacts]
        self.indices = [f if f == h else [f, h] for f, h in zip(records["face"], records["hull"])]

    def is_plain(self, place):
        index = self.indices[place]
        return index in (1, 2) and len(self.contacts[place]) == index + 1

    def framed(self, position):
        origin, unit = self.data["origin"], self.data["unit"]
        return [float((fractions.Fraction(x) - fractions.Fraction(o)) / fractions.Fraction(unit))
                for x, o in zip(position, origin)]


class ViewTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = {}
        for name, text in INPUTS.items():
            lines = run("compute", "-", "--manifolds", "u2,s2", "-o", "-", text=text).splitlines()
            header, *records = map(json.loads, lines)
            cls.made[name] = (text, Page(view(text)), header, records)

    def on_each_input(self, check):
        for name, made in self.made.items():
            with self.subTest(name):
                check(*made)

    def test_stationary_points(self):
        def check(_0, page, header, records):
            data = page.data
            for key in ("points", "merged_duplicates", "critical", "regular_stationary", "input_sha256"):
                self.assertEqual(data[key], header[key])
            samples = [r for r in records if r["index"] == 0]
            self.assertEqual(data["sample_rows"], [r["contact"][0] for r in samples])
            self.assertEqual(page.samples, [tuple(float(fractions.Fraction(x)) for x in r["center"]) for r in samples])
            others = [r for r in records if r["index"] != 0]
            self.assertEqual(page.names, [r["contact"] for r in others])
            self.assertEqual(page.indices, [r["index"] for r in others])
            self.assertEqual(data["records"]["numbers"], list(range(len(samples), len(records))))
            self.assertIsNone(data["thinned"])
            self.assertIsNone(data["claim"])

        self.on_each_input(check)

    def test_positions_of_points_that_are_not_plain(self):
        def check(_0, page, _2, records):
            others = [r for r in records if r["index"] != 0]
            given = [r for k, r in enumerate(others) if not page.is_plain(k)]
            self.assertEqual(len(page.data["records"]["squared"]), len(given))
            for record, at, squared in zip(given, triples(page.data["records"]["positions"]),
                                           page.data["records"]["squared"]):
                for x, y in zip(at, page.framed(map(fractions.Fraction, record["center"]))):
                    self.assertAlmostEqual(x, y, delta=2e-7)
                if record["squared_distance_double"] is None:
                    self.assertEqual(squared, math.inf)
                else:
                    self.assertEqual(squared, record["squared_distance_double"])

        self.on_each_input(check)

    def test_edges_have_their_midpoints_at_the_points(self):
        def check(_0, page, _2, records):
            others = [r for r in records if r["index"] != 0]
            edges = page.data["records"]["edges"]
            for k, record in enumerate(others):
                a, b = edges[2 * k: 2 * k + 2]
                face = page.data["records"]["face"][k]
                self.assertEqual((a, b) != (NONE, NONE), face == 1)
                if face != 1:
                    continue
                self.assertLessEqual({a, b}, set(page.contacts[k]))
                middle = [(fractions.Fraction(x) + fractions.Fraction(y)) / 2
                          for x, y in zip(page.samples[a], page.samples[b])]
                self.assertEqual(middle, [fractions.Fraction(x) for x in record["center"]])

        self.on_each_input(check)

    def test_the_frame_fits_the_samples(self):
        def check(_0, page, _2, _3):
            framed = [page.framed(sample) for sample in page.samples]
            largest = max(abs(x) for row in framed for x in row)
            self.assertLessEqual(largest, 1 + 1e-15)
            if len(framed) > 1:
                self.assertGreaterEqual(largest, 1 - 1e-15)

        self.on_each_input(check)

    def test_pairs(self):
        def check(text, page, _2, _3):
            listed = json.loads(run("persistence", "-", "--json", text=text))["pairs"]
            ends = [(p["dimension"], p["birth"]["contact"], p["death"] and p["death"]["contact"]) for p in listed]
            pairs, rows = page.data["pairs"], page.data["sample_rows"]
            shown = []
            for dimension, birth, death, sample in zip(*(pairs[key] for key in ("dimension", "birth", "death",
                                                                                "birth_sample"))):
                self.assertEqual((birth == NONE, sample == NONE), (dimension == 0, dimension != 0))
                shown.append((dimension, [rows[sample]] if dimension == 0 else page.names[birth],
                              None if death == NONE else page.names[death]))
            self.assertEqual(sorted(shown, key=repr), sorted(ends, key=repr))

        self.on_each_input(check)

    def test_surfaces(self):
        def check(text, page, _2, records):
            with tempfile.TemporaryDirectory() as folder:
                counts = json.loads(run("surface", "-", "-o", f"{folder}/all.ply", "--json", text=text))
            s2 = page.data["s2"]
            self.assertEqual(len(s2["record"]), counts["sets"])
            self.assertEqual(3 * counts["triangles"], len(s2["triangles"]))
            self.assertEqual(3 * counts["vertices"], len(s2["vertices"]))
            twos = [k for k, r in enumerate(r for r in records if r["index"] != 0) if r["index"] == 2]
            self.assertEqual(s2["record"], twos)
            self.assertEqual(sum(s2["has_interval"]), counts["with_interval"])
            sets = slices(s2["triangle_offsets"], triples(s2["triangles"]))
            others = [r for r in records if r["index"] != 0]
            for k, triangles in zip(twos, sets):
                self.assertEqual(len(triangles), 2 * others[k]["stable"]["segments"])
                corners = {v for triangle in triangles for v in triangle}
                self.assertTrue(all(v < counts["vertices"] for v in corners))

        self.on_each_input(check)

    # {percent: (triangles of positions, edges by their places)} of the k-th pair that has cycles.
    def chains(self, page, k, percents):
        s2, cycles = page.data["s2"], page.data["cycles"]
        vertices = triples(s2["vertices"]) + triples(cycles["vertices"])
        pieces = [piece for part in (s2, cycles)
                  for piece in slices(part["triangle_offsets"], triples(part["triangles"]))]
        steps = range(cycles["step_offsets"][k], cycles["step_offsets"][k + 1])
        self.assertEqual(cycles["percent"][steps[0]], 100)
        found = {}
        for percent in percents:
            down = [step for step in steps if cycles["percent"][step] >= percent]
            chain = mod_2(cycles["piece_offsets"], cycles["pieces"], down)
            triangles = [[vertices[corner] for corner in triangle] for piece in chain for triangle in pieces[piece]]
            found[percent] = triangles, mod_2(cycles["edge_offsets"], cycles["edges"], down)
        return found

    # The mod 2 boundary of triangles: from a sample to a midpoint, and on to another sample.
    def check_boundary(self, page, triangles, edges):
        odd = set()
        for triangle in triangles:
            for ends in ((0, 1), (1, 2), (2, 0)):
                odd ^= {frozenset(triangle[end] for end in ends)}
        halves = []
        for edge in edges:
            a, b = ([*page.framed(page.samples[s])] for s in page.data["records"]["edges"][2 * edge: 2 * edge + 2])
            halves += [(end, [(x + y) / 2 for x, y in zip(a, b)]) for end in (a, b)]
        near = lambda a, b: math.dist(a, b) < 1e-6
        left = [tuple(side) for side in odd if len(side) == 2]
        self.assertEqual(len(left), len(halves))
        for a, b in halves:
            self.assertTrue(any((near(a, c) and near(b, d)) or (near(a, d) and near(b, c)) for c, d in left))

    def test_cycles(self):
        seen = collections.Counter()
        levels = (0, 25, 60)

        def check(text, page, _2, _3):
            pairs, cycles = page.data["pairs"], page.data["cycles"]
            self.assertEqual(set(cycles["least"]), {0} if cycles["pair"] else set())
            seen["own pieces"] += len(cycles["triangle_offsets"]) > 1
            for dimension in (1, 2):
                shown = [k for k, pair in enumerate(cycles["pair"]) if pairs["dimension"][pair] == dimension]
                chains = [self.chains(page, k, levels) for k in shown]
                for level in levels:
                    listed = json.loads(run("cycles", "-", "--json", "--dimension", dimension, "--longest", "100",
                                            "--level", f"{level}%", text=text))["cycles"]
                    self.assertEqual([[page.names[pairs[end][cycles["pair"][k]]] for end in ("birth", "death")]
                                      for k in shown], [[c["birth"]["contact"], c["death"]["contact"]] for c in listed])
                    for chain, told in zip(chains, listed):
                        triangles, edges = chain[level]
                        self.assertTrue(triangles)
                        self.assertEqual(sorted(page.names[edge] for edge in edges), sorted(told.get("edges", [])))
                        self.check_boundary(page, triangles, edges)
                        seen[dimension] += 1

        self.on_each_input(check)
        self.assertGreater(seen[1], 100)
        self.assertGreater(seen[2], 50)
        self.assertGreater(seen["own pieces"], 0)

    def test_cycles_at_the_death_are_its_own_surface_or_cell(self):
        page = self.made["scattered"][1]
        pairs, s2 = page.data["pairs"], page.data["s2"]
        for k, pair in enumerate(page.data["cycles"]["pair"]):
            triangles, _ = self.chains(page, k, [100])[100]
            if pairs["dimension"][pair] == 1:
                place = s2["record"].index(pairs["death"][pair])
                offsets = s2["triangle_offsets"][place: place + 2]
                self.assertEqual(len(triangles), offsets[1] - offsets[0])

    def test_lines(self):
        def check(_0, page, _2, records):
            others = [r for r in records if r["index"] != 0]
            u2 = page.data["u2"]
            steps = triples(u2["steps"])
            at = []
            for k, ahead in enumerate(steps):
                self.assertTrue(u2["next"][k] == NONE or u2["next"][k] < k)
                base = at[u2["next"][k]] if u2["next"][k] != NONE else (0, 0, 0)
                at.append(tuple(b + (n // 2 if n % 2 == 0 else -(n // 2) - 1) for b, n in zip(base, ahead)))
            for i, place in enumerate(u2["record"]):
                record = others[place]
                self.assertEqual(record["index"], 2)
                for side, end in enumerate(record["limits"]):
                    limit = u2["limits"][2 * i + side]
                    if end is None:
                        self.assertEqual(limit, NONE)
                    else:
                        self.assertEqual(page.names[limit], end)
                    self.check_line(page, [u2["step"], at, u2["next"]], u2["starts"][2 * i + side], record,
                                    None if limit == NONE else others[limit])

        self.on_each_input(check)

    def check_line(self, page, forest, vertex, source, target):
        step, at, following = forest
        line = [vertex]
        while following[line[-1]] != NONE:
            line.append(following[line[-1]])
        for end, record in ((line[0], source), (line[-1], target)):
            if record is None:
                continue
            for x, y in zip(at[end], page.framed(map(fractions.Fraction, record["center"]))):
                self.assertAlmostEqual(x * step, y, delta=step)
        for inner in line[:-1]:
            self.assertLessEqual(max(abs(x) * step for x in at[inner]), 3 + step)
        if target is None:
            self.assertGreater(max(abs(x) * step for x in at[line[-1]]), 3 - step)

    def test_cells(self):
        def check(text, page, _2, _3):
            self.assertNotIn("cells", page.data)
            data = view(text, "--cells")
            cells = data.pop("cells")
            self.assertEqual(data, page.data)
            self.check_cells(cells, page, text)

        self.on_each_input(check)

    def check_cells(self, cells, page, text):
        lines = run("compute", "-", "--manifolds", "all", "-o", "-", text=text).splitlines()
        records = [json.loads(line) for line in lines[1:]]
        shown = [records[number] for number in page.data["records"]["numbers"]]
        self.assertEqual(cells["volumes"], [math.inf if r["volume_double"] is None else r["volume_double"]
                                            for r in shown])
        self.assertEqual(len(cells["offsets"]), len(shown) + 1)
        ways = [[{"to": None if to == NONE else records[to]["contact"], "orbits": orbits, "families": families}
                 for to, orbits, families in connections]
                for connections in slices(cells["offsets"], list(zip(cells["to"], cells["orbits"], cells["families"])))]
        self.assertEqual(ways, [r.get("connections", []) for r in shown])

    # Triangles around each cell that is drawn, seen from outside, by its place in the records.
    def triangles_around(self, page):
        cells = page.data["cells"]
        faces = slices(cells["faces"]["triangle_offsets"], triples(cells["faces"]["triangles"]))
        between = cells["faces"]["between"]
        numbers_of_drawn = {page.data["records"]["numbers"][place]: place for place in cells["drawn"]}
        around = {place: [] for place in cells["drawn"]}
        for a, b, triangles in zip(between[::2], between[1::2], faces, strict=True):
            self.assertLess(a, b)
            self.assertTrue(a in numbers_of_drawn or b in numbers_of_drawn)
            if a in numbers_of_drawn:
                around[numbers_of_drawn[a]] += triangles
            if b in numbers_of_drawn:
                around[numbers_of_drawn[b]] += [(y, x, z) for x, y, z in triangles]
        return around

    def check_faces(self, page):
        around = self.triangles_around(page)
        vertices = triples(page.data["cells"]["faces"]["vertices"])
        for place, triangles in around.items():
            passed = collections.Counter(edge for x, y, z in triangles for edge in ((x, y), (y, z), (z, x)))
            self.assertTrue(triangles)
            for (x, y), times in passed.items():
                self.assertEqual(passed[y, x], times)
            # The vertices are floats of the frame, so that each coordinate is wrong by at most 2^-25.
            exactly = [[fractions.Fraction(x) for x in vertex] for vertex in vertices]
            six = sum(determinant(*(exactly[corner] for corner in triangle)) for triangle in triangles)
            volume = page.data["cells"]["volumes"][place]
            unit = page.data["unit"]
            if 1e-90 < unit < 1e90:
                self.assertAlmostEqual(float(six / 6), volume / unit ** 3, delta=len(triangles) * 2 ** -24)
        return around

    def test_cells_are_closed_around_their_volumes(self):
        drawn = 0

        def check(text, _1, _2, records):
            nonlocal drawn
            page = Page(view(text, "--cells"))
            cells = page.data["cells"]
            maxima = {k for k, index in enumerate(page.indices) if index == 3}
            self.assertEqual(cells["of"], len(cells["drawn"]))
            self.assertLessEqual(maxima, set(cells["drawn"]))
            self.assertLessEqual({k for k, volume in enumerate(cells["volumes"]) if volume > 0}, set(cells["drawn"]))
            drawn += len(self.check_faces(page))

        self.on_each_input(check)
        self.assertGreater(drawn, 40)

    def test_as_many_cells_and_surfaces_as_are_asked_for(self):
        text = INPUTS["scattered"]
        whole = Page(view(text, "--cells"))
        some = Page(view(text, "--cells", "--most-cells", "5", "--most-unstable", "7"))
        none = Page(view(text, "--cells", "--most-cells", "0", "--most-unstable", "0"))
        volumes = whole.data["cells"]["volumes"]
        self.assertEqual(sorted((volumes[k] for k in some.data["cells"]["drawn"]), reverse=True),
                         sorted(volumes, reverse=True)[:5])
        around, of_all = self.check_faces(some), self.check_faces(whole)
        for place, triangles in around.items():
            self.assertEqual(len(triangles), len(of_all[place]))
        lengths = {}
        for pair in json.loads(run("persistence", "-", "--json", text=text))["pairs"]:
            ends = [end for end in (pair["birth"], pair["death"]) if end]
            values = [fractions.Fraction(end["squared_distance"]) for end in ends]
            for end in ends:
                lengths[tuple(end["contact"])] = values[1] - values[0] if len(ends) == 2 else math.inf
        lengths = {k: lengths[tuple(name)] for k, name in enumerate(whole.names) if whole.indices[k] == 1}
        chosen = some.data["cells"]["u1"]["record"]
        self.assertEqual(len(chosen), 7)
        self.assertGreaterEqual(min(lengths[k] for k in chosen), sorted(lengths.values())[-7])
        for page in (some, none):
            self.assertEqual(page.data["cells"]["of"], whole.data["cells"]["of"])
            self.assertEqual(page.data["cells"]["u1"]["of"], whole.indices.count(1))
        self.assertEqual((none.data["cells"]["drawn"], none.data["cells"]["u1"]["record"]), ([], []))
        self.assertEqual((none.data["cells"]["faces"]["triangles"], none.data["cells"]["u1"]["corners"]), ([], []))

    def surfaces_of(self, page):
        """[(place in the records, sheets, lines)], in positions of the frame."""
        u1 = page.data["cells"]["u1"]
        at = triples(u1["vertices"])
        sheets = [[at[k] for k in corners] for corners in slices(u1["corner_offsets"], u1["corners"])]
        lines = [(at[a], at[b]) for a, b in zip(u1["lines"][::2], u1["lines"][1::2], strict=True)]
        return list(zip(u1["record"], slices(u1["sheet_offsets"], sheets), slices(u1["line_offsets"], lines),
                        strict=True))

    # How many samples are nearest to the point.
    @staticmethod
    def nearest_count(page, point):
        distances = [math.dist(point, page.framed(sample)) for sample in page.samples]
        return sum(distance < min(distances) + 1e-5 for distance in distances)

    def test_unstable_surfaces_are_on_voronoi_facets(self):
        seen = collections.Counter()

        def check(text, _1, _2, _3):
            page = Page(view(text, "--cells"))
            surfaces = self.surfaces_of(page)
            of_dimension_2 = [k for k, face in enumerate(page.data["records"]["face"]) if face == 1]
            self.assertEqual([place for place, _, _ in surfaces], of_dimension_2)
            self.assertEqual(page.data["cells"]["u1"]["of"], len(of_dimension_2))
            for _, sheets, lines in surfaces:
                self.assertTrue(sheets)
                for corners in [*sheets, *lines]:
                    self.assertLessEqual(max(abs(x) for corner in corners for x in corner), 3 + 1e-6)
                    middle = [sum(xs) / len(corners) for xs in zip(*corners)]
                    self.assertGreaterEqual(self.nearest_count(page, middle), 2)
                for corners in sheets:
                    self.assertGreaterEqual(len(corners), 3)
                    self.assertTrue(all(self.nearest_count(page, corner) >= 2 for corner in corners))
                    seen["sheets"] += 1
                    seen["at the box"] += any(abs(x) > 3 - 1e-6 for corner in corners for x in corner)
                seen["lines"] += len(lines)

        self.on_each_input(check)
        self.assertGreater(seen["sheets"], 300)
        self.assertGreater(seen["at the box"], 100)
        self.assertGreater(seen["lines"], 20)

    # Areas in the frame. What lies behind the centre flows to it.
    def test_known_unstable_surfaces(self):
        for text, areas in ((INPUTS["cube"], [9]), ("0 0 0\n1 0 0\n3 0 0\n", [36]),
                            ("0 0 0\n2 0 0\n2 2 0\n0 2 0\n", [18]), ("0 0 0\n2 0 0\n1 3 0\n", None)):
            page = Page(view(text, "--cells"))
            for place, sheets, lines in self.surfaces_of(page):
                area = sum(polygon_area(corners) for corners in sheets)
                if areas:
                    self.assertAlmostEqual(area, areas[0], delta=1e-5)
                    self.assertEqual(lines, [])
                else:
                    # A triangle's three half planes, each from its centre on.
                    self.assertGreater(area, 9)
                    self.assertEqual(page.indices[place], 1)

    def test_known_volumes_and_connections(self):
        page = Page(view(INPUTS["flows-to-a-saddle"], "--cells"))
        cells = page.data["cells"]
        volumes = {tuple(name): volume for name, volume in zip(page.names, cells["volumes"]) if volume > 0}
        self.assertEqual(sorted(volumes.values()), [45, 45, 50])
        self.assertEqual(volumes[0, 3, 4], 50)
        place = page.names.index([0, 1, 2])
        to = cells["to"][cells["offsets"][place]: cells["offsets"][place + 1]]
        self.assertIn(page.data["records"]["numbers"][page.names.index([0, 3, 4])], to)

    def test_cells_of_a_thinned_complex_name_what_it_left_out(self):
        text = INPUTS["scattered"]
        thin = Page(view(text, "--cells", "--most", "3"))
        self.check_cells(thin.data["cells"], thin, text)
        numbers_here = {*thin.data["records"]["numbers"], NONE}
        self.assertTrue(any(to not in numbers_here for to in thin.data["cells"]["to"]))

    def test_a_large_complex_is_thinned_to_the_longest_pairs(self):
        text = INPUTS["scattered"]
        whole, thin = Page(view(text)), Page(view(text, "--most", "10"))
        self.assertEqual(thin.data["thinned"], {"of": len(whole.names), "kept": len(thin.names)})
        self.assertLess(len(thin.names), len(whole.names))
        self.assertEqual(thin.data["critical"], whole.data["critical"])
        listed = json.loads(run("persistence", "-", "--json", text=text))["pairs"]
        value = lambda end: fractions.Fraction(end["squared_distance"])
        # To so many digits that those of different pairs differ.
        root = lambda square: math.isqrt(square.numerator * 10**80 // square.denominator)
        length = lambda p: root(value(p["death"])) - root(value(p["birth"]))
        lengths = {repr(p["death"]["contact"]) + repr(p["birth"]["contact"]): length(p)
                   for p in listed if p["dimension"] > 0}
        pairs = thin.data["pairs"]
        kept = [lengths[repr(thin.names[death]) + repr(thin.names[birth])]
                for dimension, birth, death in zip(pairs["dimension"], pairs["birth"], pairs["death"]) if dimension > 0]
        self.assertEqual(sorted(kept), sorted(lengths.values())[-10:])
        self.assertEqual(len(pairs["dimension"]), 20)
        self.assertEqual(len(thin.data["s2"]["record"]), sum(i == 2 for i in thin.indices))
        self.assertTrue(all(limit == NONE or limit < len(thin.names) for limit in thin.data["u2"]["limits"]))

    def test_cycles_of_a_thinned_complex_are_whole(self):
        text = INPUTS["scattered"]
        thin = Page(view(text, "--most", "40"))
        pairs, cycles = thin.data["pairs"], thin.data["cycles"]
        dimensions = [pairs["dimension"][pair] for pair in cycles["pair"]]
        self.assertEqual(dimensions.count(1), pairs["dimension"].count(1))
        self.assertLess(dimensions.count(2), pairs["dimension"].count(2))
        self.assertLessEqual(max(cycles["least"]), 25)
        self.assertGreater(max(cycles["least"]), 0)
        for k, least in enumerate(cycles["least"]):
            for triangles, edges in self.chains(thin, k, (least, 25, 60)).values():
                self.check_boundary(thin, triangles, edges)

    def test_what_is_wrong_with_a_claim(self):
        claim = "index,x,y,z\n0,0,0,0\n2,0.5,0.5,0\n2,1,1,0\n"
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "claim<b>&.csv"
            path.write_text(claim)
            data = view(INPUTS["pyramid"], "--claim", path, status=1)
            report = json.loads(run("check", "-", path, "--json", text=INPUTS["pyramid"], status=1))
        shown = data["claim"]
        self.assertEqual(shown["verdict"], report["verdict"])
        self.assertEqual(shown["findings_count"], len(report["findings"]))
        self.assertTrue(shown["name"].endswith("claim<b>&.csv"))
        key = lambda finding: (finding["reason"], finding["line"] or 0, finding["claimed"], finding["truth"])
        self.assertEqual(sorted(map(key, shown["findings"])), sorted(map(key, report["findings"])))
        page = Page(data)
        wrong = next(f for f in shown["findings"] if f["line"] == 3)
        self.assertEqual(wrong["position"], page.framed([0.5, 0.5, 0]))
        claimed = next(s for s in wrong["spheres"] if s["role"] == "claimed")
        # The nearest sample is the origin, so nothing is inside, and the sphere is not that of a stationary point.
        self.assertEqual((claimed["inside"], claimed["on"], claimed["empty"]), ([], [0], True))
        self.assertAlmostEqual(claimed["radius"] * data["unit"], math.sqrt(0.5), delta=1e-6)
        missing = [f for f in shown["findings"] if f["reason"].startswith("miss")]
        self.assertTrue(missing)
        for finding in missing:
            true = next(s for s in finding["spheres"] if s["role"] == "true")
            self.assertTrue(true["empty"])
            self.assertEqual(true["on"], finding["contact"])
            if finding["index"] != 0:
                self.assertEqual(page.contacts[finding["record"]], finding["contact"])

    def test_samples_inside_a_claimed_sphere(self):
        claim = '{"format": "flowcert-stationary-points", "format_version": 1, "points": 5}\n' \
                '{"index": 2, "contact": [0, 1, 4]}\n'
        points = "0 0 0\n2 0 0\n1 0.25 0.25\n9 9 9\n1 1 3\n"
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "claim.jsonl"
            path.write_text(claim)
            finding = next(f for f in view(points, "--claim", path, status=1)["claim"]["findings"] if f["line"] == 2)
        sphere = next(s for s in finding["spheres"] if s["role"] == "claimed")
        self.assertEqual(sphere["inside"], [2])
        self.assertEqual(sphere["on"], [0, 1, 4])
        self.assertFalse(sphere["empty"])

    def test_names_cannot_become_markup(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "<img src=x onerror=alert(1)> <!-- .xyz"
            path.write_text("0 0 0\n1 0 0\n")
            page = run("view", path, "-o", "-")
        self.assertNotIn("<img src=x", page)
        self.assertTrue(data_of(page)["name"].endswith("<img src=x onerror=alert(1)> <!-- .xyz"))

    def test_the_page_has_the_input_s_name(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scan.one.xyz"
            path.write_text(INPUTS["cube"])
            done = subprocess.run([FLOWCERT, "view", path], cwd=folder, capture_output=True, check=True)
            self.assertIn(b"scan.one.html: open it in a browser", done.stdout)
            self.assertEqual(data_of((pathlib.Path(folder) / "scan.one.html").read_text())["points"], 8)
            self.assertEqual(len(list(pathlib.Path(folder).iterdir())), 2)

    def test_unusable_input_leaves_no_page(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.html"
            claim = pathlib.Path(folder) / "claim.csv"
            claim.write_text("index,x,y,z\n7,0,0,zero\n")
            run("view", "-", "-o", page, text="0 0 nan\n", status=2)
            run("view", "-", "-o", page, "--claim", claim, text="0 0 0\n", status=2)
            run("view", "-", "-o", page, "--strict", text="0 0 0\n", status=2)
            run("view", "-", "-o", page, "--claim", "-", text="0 0 0\n", status=2)
            self.assertEqual([p.name for p in pathlib.Path(folder).iterdir()], ["claim.csv"])

    def test_points_are_not_replaced_by_their_page(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "points.html"
            path.write_text(INPUTS["cube"])
            done = subprocess.run([FLOWCERT, "view", path.name], cwd=folder, capture_output=True, check=False)
            self.assertEqual((done.returncode, path.read_text()), (2, INPUTS["cube"]))
            self.assertIn(b"the page would replace these points", done.stderr)

    def test_a_page_may_go_where_nothing_has_a_size(self):
        with tempfile.TemporaryDirectory() as folder:
            claim = pathlib.Path(folder) / "claim.csv"
            claim.write_text("index,x,y,z\n1,0,0,0\n")
            self.assertIn("/dev/null: open it", run("view", "-", "-o", "/dev/null", text=INPUTS["cube"]))
            run("view", "-", "-o", "/dev/null", "--claim", claim, text=INPUTS["cube"], status=1)

    def test_extreme_frames(self):
        # The least doubles, which have no halves, and the greatest, whose differences overflow.
        for text in ("0 0 0\n1e-323 0 0\n5e-324 1e-323 0\n", "0 0 0\n5e-324 0 0\n0 5e-324 5e-324\n",
                     "1.7e308 0 0\n-1.7e308 0 0\n0 1.7e308 -1.7e308\n1e308 1e308 1e308\n"):
            data = view(text)
            for at in triples(data["s2"]["vertices"]):
                self.assertLessEqual(max(map(abs, at)), 1 + 1e-6)
            self.assertTrue(all(n < 2 ** 31 for n in data["u2"]["steps"]))

    def test_directions_to_infinity_do_not_depend_on_the_unit(self):
        points = [(i * 37 % 101, i * 61 % 97, i * 53 % 89) for i in range(40)]
        pages = [view("".join(f"{math.ldexp(x, k)!r} {math.ldexp(y, k)!r} {math.ldexp(z, k)!r}\n" for x, y, z in points))
                 for k in (0, 1000, -900)]
        for page in pages[1:]:
            self.assertEqual(page["u2"], pages[0]["u2"])

    def test_atoms_are_named_by_their_rows(self):
        names = ["N", "CA", "C", "O", "N"]
        text = "".join(f"ATOM  {i + 1:5d}  {name:<3s} GLY A{i // 4 + 1:4d}    {i:8.3f}   0.000{i * i % 5:8.3f}"
                       f"  1.00  0.00          {name[0]:>2s}\n" for i, name in enumerate(names))
        atoms = view(text)["atoms"]
        self.assertEqual([atoms["elements"][place] for place in atoms["element"]], ["N", "C", "C", "O", "N"])
        self.assertEqual(len(set(atoms["elements"])), len(atoms["elements"]))
        self.assertEqual(atoms["names"], ["A GLY 1 N", "A GLY 1 CA", "A GLY 1 C", "A GLY 1 O", "A GLY 2 N"])
        self.assertIsNone(view("0 0 0\n1 0 0\n")["atoms"])

    def test_pockets_have_the_square_of_their_persistence(self):
        cube = "".join(f"{x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
        self.assertNotIn("pockets", view(cube))
        pockets = view(cube, "--pockets", "0.125")["pockets"]
        self.assertEqual(pockets["squared_persistence"], "1/64")
        self.assertEqual(pockets["of"], len(pockets["depth"]))
        self.assertAlmostEqual(pockets["depth"][0], math.sqrt(0.75) - math.sqrt(0.5))

    def test_balls_have_what_pores_says_of_them(self):
        # The second ball is hidden in the first one, and the last two have one centre.
        equal = "2 2 2 1\n2 2 2.25 0.5\n2 -2 -2 1\n-2 2 -2 1\n-2 -2 2 1\n-2 -2 2 1\n"
        for text, radii, options in ((CAGE.read_text(), "bondi", ["--depth", "1/2", "--probe", "2"]),
                                     (equal, "column:4", ["--depth", "0"]), ("# none\n", "1", [])):
            data = view(text, "--radii", radii, *options)
            told = json.loads(run("pores", "-", "--radii", radii, *options, "--json", text=text))
            told.pop("cavities")
            self.assertEqual(data["pores"], told)
            self.assertEqual((data["format"], data["points"]), ("flowcert-view", told["balls"]))
            self.assertEqual(data["sample_rows"], list(range(told["balls"])))
            self.assertNotIn("records", data)
            corners = []
            for place, radius in zip(triples(data["samples"]), data["radii"], strict=True):
                corners += [(x + side * radius - o) / data["unit"] for x, o in zip(place, data["origin"])
                            for side in (-1, 1)]
            self.assertAlmostEqual(max(map(abs, corners), default=1), 1)
        self.assertEqual(view(equal, "--radii", "column:4")["radii"], [1, 0.5, 1, 1, 1, 1])
        atoms = view(CAGE.read_text(), "--radii", "bondi")["atoms"]
        self.assertEqual([atoms["elements"][k] for k in atoms["element"]], atoms["names"])

    def test_radii_exclude_what_is_of_points(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.html"
            for options in (["--radii", "bondi", "--pockets", "auto"], ["--radii", "bondi", "--claim", CAGE],
                            ["--radii", "bondi", "--cells"], ["--radii", "bondi", "--most", "5"], ["--depth", "1"],
                            ["--radii", "bondi", "--depth", "-1"], ["--probe", "1"], ["--radii", "none"]):
                done = subprocess.run([FLOWCERT, "view", CAGE, "-o", page, *options], capture_output=True, check=False)
                self.assertEqual((done.returncode, done.stdout, done.stderr.count(b"\n")), (2, b"", 1), options)
            self.assertFalse(page.exists())
            done = run("view", CAGE, "-o", page, "--radii", "bondi", "--depth", "0.5")
            self.assertIn("chambers                                       1   of depth 0.5 or more\n", done)
            self.assertIn("cage.xyz", data_of(page.read_text())["name"])

    def test_no_points(self):
        data = view("# nothing\n")
        self.assertEqual((data["points"], data["samples"], data["records"]["contacts"]), (0, [], []))


class FindingPagesTest(unittest.TestCase):
    def test_conformance_keeps_pages_and_reports(self):
        with tempfile.TemporaryDirectory() as folder:
            kept, report = pathlib.Path(folder) / "kept files", pathlib.Path(folder) / "report.html"
            command = CLAIMS_A_SADDLE
            run("conformance", "--against", command, "--keep", kept, "--report", report, "--group", "flat-inputs",
                status=1)
            page = report.read_text()
            folders = sorted(p.name for p in kept.iterdir())
            self.assertTrue(folders)
            shown = 0
            for name in folders:
                case = json.loads((kept / name / "case.json").read_text())
                self.assertIn(f'id="case-{name}"', page)
                self.assertIn(f'href="kept%20files/{name}/"', page)
                has_points = bool(case.get("points"))
                self.assertEqual((kept / name / "page.html").exists(), has_points)
                self.assertEqual(f'href="kept%20files/{name}/page.html"' in page, has_points)
                if not has_points:
                    continue
                data = data_of((kept / name / "page.html").read_text())
                self.assertEqual((data["name"], data["claim"]["verdict"]), (name, "fails"))
                shown += 1
            self.assertGreater(shown, 0)
            self.assertIn("&amp;&amp; printf 'index", page)
            self.assertNotIn("http", page.split("</style>")[1])

    def test_a_wrong_orbit_s_page_has_the_claim_that_is_right(self):
        with tempfile.TemporaryDirectory() as folder:
            kept, report = pathlib.Path(folder) / "kept", pathlib.Path(folder) / "sub" / ".." / "report.html"
            (pathlib.Path(folder) / "sub").mkdir()
            run("conformance", "--against", f"{FLOWCERT} compute {{in}} -o -", "--orbits-against",
                "echo '{}'; : {in} {start}", "--case", "orbits-0001", "--keep", kept, "--report", report, status=1)
            data = data_of((kept / "orbits-0001" / "page.html").read_text())
            self.assertIsNone(data["claim"])
            self.assertIn('href="kept/orbits-0001/page.html"', report.read_text())

    def test_fuzz_writes_a_page_beside_each_finding(self):
        with tempfile.TemporaryDirectory() as folder:
            campaign = pathlib.Path(folder) / "campaign"
            run("fuzz", "--count", "30", "--against", CLAIMS_A_SADDLE, "--out", campaign,
                status=1)
            files = sorted((campaign / "findings").iterdir())
            points = [p for p in files if p.suffix == ".xyz"]
            self.assertTrue(points)
            for path in points:
                data = data_of(path.with_suffix(".html").read_text())
                self.assertEqual(data["name"], path.stem)
                self.assertEqual(data["claim"]["verdict"], "fails")
                rows = [line for line in path.read_text().splitlines() if not line.startswith("#")]
                self.assertEqual(data["points"], len(rows))


if __name__ == "__main__":
    FLOWCERT = sys.argv.pop()
    unittest.main()
