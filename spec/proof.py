#!/usr/bin/env python3
"""Proves that cells are a Delaunay triangulation of points, and that a list has all stationary points, or rejects them.

    proof.py SCAN CERTIFICATE [LIST]                       LIST: as `flowcert compute SCAN -o LIST` writes it
    proof.py SCAN --cells FILE [--from-cells CERTIFICATE]  FILE: d+1 rows of SCAN a line, in any order

SCAN is .xyz, three decimals a row, or .f64, raw doubles. A certificate (.fcert) has cells, and who made it does not
matter: the conditions T0 to T8 of FC-CERT-02 say whether they are a Delaunay triangulation. It has all stationary
points by FC-CERT-03, and tells their kinds and contact sets; the list has to be the same, line by line. --cells asks
the same of a plain list of cells. Only integers decide: coordinates are integers times one power of two.
Exit status: 0 if all of it is proved, 1 if a condition fails or the list differs, 2 for what cannot be decoded.
"""
import argparse, hashlib, math, re, struct, sys
from fractions import Fraction
from itertools import combinations
from pathlib import Path

sys.set_int_max_str_digits(0)


class Rejected(Exception):
    """A condition of FC-CERT-02 fails, or a list is not that of the stationary points."""


class Undecodable(Exception):
    """What cannot be read: nothing is said of it."""


# ---- Vectors of integers


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def weighed_sum(weights, vectors):
    return tuple(sum(weight * v[k] for weight, v in zip(weights, vectors)) for k in range(3))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# ---- Points

DECIMAL = rb"-?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:e[+-]?[0-9]+)?"
ROW = re.compile(rb"(%b)[ \t]+(%b)[ \t]+(%b)(?:\r?\n)?" % (DECIMAL, DECIMAL, DECIMAL))


def rows_in(path):
    """The rows of a file of points; an empty one for what is no row."""
    with open(path, "rb") as file:
        if path.endswith(".xyz"):
            for line in file.readlines() or [b""]:
                found = ROW.fullmatch(line)
                yield tuple(map(float, found.groups())) if found else ()
        elif path.endswith(".f64"):
            while row := file.read(24):
                yield struct.unpack("<3d", row) if len(row) == 24 else ()
        else:
            raise Undecodable(f"{path}: neither .xyz nor .f64")


class Points:
    """The rows of a file. Equal ones are a class, which has the number of its first row as its name."""

    def __init__(self, path):
        digest, ratios, classes = hashlib.sha256(), [], {}
        for number, row in enumerate(rows_in(path), 1):
            if not row or not all(map(math.isfinite, row)):
                raise Undecodable(f"{path}:{number}: not three finite numbers")
            digest.update(struct.pack("<3d", *(x + 0.0 for x in row)))  # of a zero without its sign
            ratios.append([x.as_integer_ratio() for x in row])
        self.sha256 = digest.hexdigest()
        self.shift = max((below.bit_length() - 1 for row in ratios for _, below in row), default=0)
        self.at = [tuple((above << self.shift) // below for above, below in row) for row in ratios]  # times 2^-shift
        for number, position in enumerate(self.at):
            classes.setdefault(position, []).append(number)
        self.name = [classes[position][0] for position in self.at]
        self.distinct = [members[0] for members in classes.values()]
        self.classes = [members for members in classes.values() if len(members) > 1]


# ---- FC-CERT-02


def face_of(simplex, turn, i):
    """The face without vertex i of an oriented simplex: its vertices sorted, and the orientation induced on it, 0 or 1.
    It is 1 where the vertices have to be permuted oddly."""
    rest = simplex[:i] + simplex[i + 1:]
    return tuple(sorted(rest)), (turn + i + sum(a > b for a, b in combinations(rest, 2))) % 2


class Triangulation:
    """Cells, of d+1 names of points each, and which of their facets are paired. Facet i is the one without vertex i.

    mates[c][i] is None, or the facet (cell, place) that facet i of cell c is paired with.
    A method that is said to be of some conditions rejects the cells unless these hold."""

    def __init__(self, points, dimension, verdict):
        self.points, self.at, self.dimension, self.verdict = points, points.at, dimension, verdict
        self.cells, self.mates = [], []
        self.facets = {}  # by sorted vertices: (cell, place, orientation) if it is open, else what a further cell is

    def reject(self, condition, where, why):
        raise Rejected(self.verdict.format(f"{condition} {where}: {why}"))

    def enter(self, cell):
        """Adds a cell, and pairs its facets with open ones (T2).

        The result has the facets that are open from now on: ((cell, place), sorted vertices)."""
        c, opened = len(self.cells), []
        self.cells.append(cell)
        self.mates.append([None] * len(cell))
        for i in range(len(cell)):
            key, turn = face_of(cell, 0, i)
            other = self.facets.get(key)
            if other is None:
                self.facets[key] = (c, i, turn)
                opened.append(((c, i), key))
            elif isinstance(other, str):
                self.reject("T2", f"cell {c}", f"{other}, {list(key)}")
            elif other[2] == turn:
                self.reject("T2", f"cell {c}", f"on the same side of the facet {list(key)} as cell {other[0]}")
            else:
                self.pair((c, i), other[:2], key)
        return opened

    def pair(self, one, other, key):
        self.mates[one[0]][one[1]], self.mates[other[0]][other[1]] = other, one
        self.facets[key] = "a third cell at the facet"

    def vectors(self, start, ends):
        return [minus(self.at[p], start) for p in ends]

    def edges(self, simplex):
        """From its first vertex to the others."""
        return self.vectors(self.at[simplex[0]], simplex[1:])

    def check_dimension(self, cells):
        """T0. In dimension 1 and 2 it finds the axis that tells volumes, one along which the first cell is not flat."""
        distinct, d, self.axis, self.turn = self.points.distinct, self.dimension, None, 1
        if min(len(distinct) - 1, 1) != min(d, 1):
            self.reject("T0", f"dimension {d}", f"there are {len(distinct)} different points")
        if d not in (1, 2):
            return
        origin, edges = self.at[cells[0][0]], self.edges(cells[0])
        normal = cross(*edges) if d == 2 else edges[0]
        self.axis = next((k for k in range(3) if normal[k]), None)
        if self.axis is None:
            self.reject("T1", "cell 0", "its volume is 0")
        self.turn = 1 if normal[self.axis] > 0 else -1
        for p, v in zip(distinct, self.vectors(origin, distinct)):
            if dot(normal, v) if d == 2 else any(cross(normal, v)):
                self.reject("T0", f"point {p}", "outside of the affine hull of cell 0")

    def volume(self, v):
        """Of d vectors, up to one positive factor. In dimension 1 and 2 the first cell has a positive one."""
        if self.dimension == 3:
            return dot(v[0], cross(v[1], v[2]))
        return self.turn * (cross(*v) if self.dimension == 2 else v[0])[self.axis]

    def facet(self, c, i):
        """The vertices w of facet i of cell c, and the sign that volume(w - x) has for x on the cell's side."""
        return self.cells[c][:i] + self.cells[c][i + 1:], -1 if i % 2 else 1

    def outside_sphere(self, cell, p):
        """Positive where a point is outside of the sphere of a cell of positive volume, 0 where it is on it.

        This is the volume of the cell lifted to the paraboloid around the point, negated. The sign is right at the
        centre: all lifts are equal there, and the sum is one of them times the volume of the cell, negated."""
        v = self.vectors(self.at[p], cell)
        return sum((1 if i % 2 else -1) * dot(u, u) * self.volume(v[:i] + v[i + 1:]) for i, u in enumerate(v))

    def check_cells(self):
        """T1, T3 and T8. cospherical[c][i]: facet i of cell c is paired, and the cell behind it has the same sphere."""
        for c, cell in enumerate(self.cells):
            if self.volume(self.edges(cell)) <= 0:
                self.reject("T1", f"cell {c}", "its volume is not positive")
        self.cospherical = [[False] * len(cell) for cell in self.cells]
        for c, cell in enumerate(self.cells):
            for i, (other, j) in [(i, mate) for i, mate in enumerate(self.mates[c]) if mate and mate[0] > c]:
                apex = self.cells[other][j]
                outside = self.outside_sphere(cell, apex)
                if outside < 0:
                    self.reject("T3", f"cell {c}", f"point {apex} of cell {other} is inside its sphere")
                self.cospherical[c][i] = self.cospherical[other][j] = outside == 0
        for p in sorted(set(self.points.distinct).difference(*self.cells)):
            self.reject("T8", f"point {p}", "no vertex of a cell")

    def check_hull(self):
        """T4 to T7, of B, the unpaired facets. B is not empty: T1 and T2 alone say so.

        In dimension 1 the only ridge is the empty one, and has both ends of the chain."""
        n, ridges = self.dimension + 1, {}
        hull = [(c, *self.facet(c, i)) for c, mates in enumerate(self.mates) for i in range(n) if not mates[i]]
        for c, w, side in hull:
            for i in range(len(w)):
                ridge, turn = face_of(w, side < 0, i)
                ridges.setdefault(ridge, []).append((turn, w[i], c, w, side))
        for ridge, sides in ridges.items():
            if len(sides) != 2 or sides[0][0] == sides[1][0]:
                self.reject("T4", f"cell {sides[0][2]}", f"{len(sides)} facets of the hull at {list(ridge)}")

        middle = weighed_sum([1] * n, [self.at[p] for p in self.cells[0]])  # o, times n; so are vectors from o
        seen = {p: weighed_sum((n, -1), (self.at[p], middle)) for _, w, _ in hull for p in w}
        for c, w, side in hull:
            if side * self.volume([seen[p] for p in w]) <= 0:
                self.reject("T5", f"cell {c}", f"the middle of cell 0 is not on the inner side of its facet {list(w)}")

        for (_, _, c, w, side), (_, opposite, *_) in ridges.values():
            if side * self.volume(self.vectors(self.at[opposite], w)) < 0:
                self.reject("T6", f"cell {c}", f"point {opposite} of the hull is outside of its facet {list(w)}")

        ray = weighed_sum((1,) * n, [seen[p] for p in hull[0][1]])
        for c, w, side in hull[1:]:
            v = [seen[p] for p in w]
            if all(side * self.volume(v[:i] + [ray] + v[i + 1:]) >= 0 for i in range(len(w))):
                self.reject("T7", f"cell {c}", f"its facet {list(w)} meets the ray through {list(hull[0][1])}")

    def center(self, simplex):
        """The centre of the smallest sphere through 1 to 4 points: a vector from the first one, times 2k, and k."""
        v = self.edges(simplex)
        if len(v) < 2:
            return v[0] if v else (0, 0, 0), 1
        a, b, c = v if len(v) == 3 else (*v, cross(*v))
        lifts = [dot(u, u) for u in v]
        return weighed_sum(lifts, (cross(b, c), cross(c, a), cross(a, b))), dot(cross(a, b), c)  # of a triangle k > 0


# ---- Certificates

COUNT = b"(0|[1-9][0-9]{0,17})"
HEAD = re.compile(b"flowcert-certificate 1\npoints %b\n(?:sha256 ([0-9a-f]{64})\n)?dimension (-1|[0-3])\ncells %b\n\n"
                  % (COUNT, COUNT))


def numbers_in(body):
    """The numbers of a body: 7 bits a byte, low ones first; the eighth bit says that the number goes on."""
    value = shift = 0
    for byte in body:
        value |= (byte & 127) << shift
        shift += 7
        if value > 1 << 33 or byte >= 128 and shift == 35:
            raise Undecodable("a number beyond 2^33, or of more than five bytes")
        if byte < 128:
            yield value
            value = shift = 0
    if shift:
        raise Undecodable("the last number is cut short")


def glue(found, first, apex_behind):
    """Enters cells: the first one, and then those behind open facets. The facet that was opened last is the next one.

    apex_behind tells the vertex that replaces one, where the facet opposite has these vertices; None: no cell is there.
    Two others are swapped, so that the new cell induces the opposite orientation on the facet."""
    stack = found.enter(first)
    while stack:
        (c, i), key = stack.pop()
        if found.mates[c][i]:
            continue
        cell = list(found.cells[c])
        cell[i] = apex_behind(cell[i], key)
        if cell[i] is None:
            found.facets[key] = "a second cell at a facet that was left unpaired"
            continue
        j, k = (0, 1) if len(cell) == 2 else [place for place in range(len(cell)) if place != i][:2]
        cell[j], cell[k] = cell[k], cell[j]
        stack += found.enter(tuple(cell))


def read_certificate(path, points):
    """The cells of a certificate, and its hash of the points or None."""
    data = Path(path).read_bytes()
    head = HEAD.match(data)
    if not head or (int(head[3]) < 1) != (int(head[4]) == 0):
        raise Undecodable(f"{path}: cannot be decoded: no header of version 1")
    if int(head[1]) != len(points.at) or head[2] and head[2].decode() != points.sha256:
        raise Undecodable(f"{path}: not of these points: their number or their sha256 differs")
    found = Triangulation(points, int(head[3]), "certificate rejected: {}, nothing is said of the list")
    announced, numbers, names = int(head[4]), numbers_in(memoryview(data)[head.end():]), set(points.distinct)

    def vertex(name):
        if name not in names:
            raise Undecodable(f"{name} is not the first row of a class of points")
        return name

    def apex_behind(opposite, _):
        code = next(numbers)
        if code and len(found.cells) == announced:
            raise Undecodable("more cells than announced")
        step = code // 2 if code % 2 else -(code // 2)  # 0, -1, 1, -2, 2 for the codes 1, 2, 3, 4, 5
        return vertex(opposite + step) if code else None

    try:
        if announced:
            glue(found, tuple([vertex(next(numbers)) for _ in range(found.dimension + 1)]), apex_behind)
        if len(found.cells) < announced or next(numbers, None) is not None:
            raise Undecodable("fewer cells than announced, or more bytes than those of the cells")
    except (Undecodable, StopIteration) as error:
        raise Undecodable(f"{path}: cannot be decoded: {str(error) or 'it is cut short'}") from None
    found.check_dimension(found.cells)
    return found, head[2]


def read_cells(path, points):
    """Cells in a file of text. They are oriented here, and get the names of their points' classes."""
    cells = []
    with open(path, "rb") as lines:
        for number, line in enumerate(lines, 1):
            is_cell = re.fullmatch(rb"[0-9]{1,10}(?:[ \t]+[0-9]{1,10}){1,3}(?:\r?\n)?", line)
            rows = tuple(map(int, line.split())) if is_cell else ()
            if not rows or max(rows) >= len(points.at) or cells and len(rows) != len(cells[0]):
                raise Undecodable(f"{path}:{number}: not rows of points, two to four and as many as in the first line")
            cells.append(tuple(points.name[row] for row in rows))
    found = Triangulation(points, len(cells[0]) - 1 if cells else len(points.at[:1]) - 1, "cells rejected: {}")
    found.check_dimension(cells)
    volumes = [found.volume(found.edges(cell)) for cell in cells]
    if 0 in volumes:
        found.reject("T1", f"cell {volumes.index(0)}", "its volume is 0")
    for cell, volume in zip(cells, volumes):
        found.enter(cell if volume > 0 else (cell[1], cell[0], *cell[2:]))
    return found


def encode(triangulation):
    """The certificate of a triangulation. The first cell comes first."""
    points, cells, numbers, apexes, body = triangulation.points, triangulation.cells, [], {}, bytearray()
    for cell in cells:
        for i, apex in enumerate(cell):
            apexes.setdefault(face_of(cell, 0, i)[0], []).append(apex)

    def apex_behind(opposite, facet):
        apex = next((p for p in apexes[facet] if p != opposite), None)
        numbers.append(0 if apex is None else 2 * (apex - opposite) + 1 if apex > opposite else 2 * (opposite - apex))
        return apex

    if cells:
        numbers += cells[0]
        glue(Triangulation(points, triangulation.dimension, ""), cells[0], apex_behind)
    for value in numbers:
        while value >= 128:
            body.append(value % 128 + 128)
            value //= 128
        body.append(value)
    return (f"flowcert-certificate 1\npoints {len(points.at)}\nsha256 {points.sha256}\n"
            f"dimension {triangulation.dimension}\ncells {len(cells)}\n\n").encode() + body


# ---- FC-CERT-03 to 05

KINDS = ["0", "1", "2", "3", "[1,2]", "[1,3]", "[2,3]"]  # as a list has them, in the order of FC-OUT-02
R12, R13, R23 = 4, 5, 6  # the places of kinds of regular points


class StationaryPoints:
    """All stationary points of a Delaunay triangulation: (place in KINDS, contact set, simplex with that centre).

    Cells with the same sphere, a cluster, are connected, and tile the hull of all points on it. All facets of cells
    with the same outward normal tile a facet of this hull."""

    def __init__(self, triangulation):
        self.t, self.at, self.dimension = triangulation, triangulation.at, triangulation.dimension
        self.cells, self.mates = triangulation.cells, triangulation.mates
        self.on_sphere, self.on_circle = [None] * len(self.cells), {}
        self.find_clusters()
        self.records = [(0, (p,), (p,)) for p in triangulation.points.distinct]
        self.find_simplices()
        self.records.sort()
        kinds = [kind for kind, _, _ in self.records]
        self.counts = [kinds.count(kind) for kind in range(len(KINDS))]

    def find_clusters(self):
        """on_sphere[c]: all points on the sphere of cell c. on_circle: in clusters of several cells, see circle."""
        for c in (c for c in range(len(self.cells)) if not self.on_sphere[c]):
            cluster, self.on_sphere[c] = [c], ()
            for k in cluster:  # it grows meanwhile
                for is_same, mate in zip(self.t.cospherical[k], self.mates[k]):
                    if is_same and self.on_sphere[mate[0]] is None:
                        self.on_sphere[mate[0]] = ()
                        cluster.append(mate[0])
            points = tuple(sorted({p for k in cluster for p in self.cells[k]}))
            for k in cluster:
                self.on_sphere[k] = points
            if self.dimension == 3 and len(cluster) > 1:
                self.find_circles(cluster)

    def find_circles(self, cluster):
        sides = {}
        for c in cluster:
            for i, is_same in enumerate(self.t.cospherical[c]):
                facet, side = self.t.facet(c, i)
                if not is_same:
                    normal = cross(*self.t.edges(facet))
                    sides.setdefault(tuple(side * x // math.gcd(*normal) for x in normal), []).append((c, i))
        for facets in sides.values():
            points = tuple(sorted({p for c, i in facets for p in self.t.facet(c, i)[0]}))
            self.on_circle.update(dict.fromkeys(facets, points))

    def circle(self, c, i):
        """All points on the circle of facet i of cell c, where its smallest sphere is empty, and the cell is not on it.

        Then it is on the hull of the cluster: a cell of the cluster behind it would have its apex in the sphere."""
        return self.on_circle.get((c, i)) or tuple(sorted(self.t.facet(c, i)[0]))

    def outside(self, simplex, p):
        """Positive where a point is outside of the smallest sphere around 2 or 3 points, 0 where it is on it."""
        (toward, k), v = self.t.center(simplex), minus(self.at[p], self.at[simplex[0]])
        return k * dot(v, v) - dot(toward, v)

    def find_simplices(self):
        """FC-CERT-04. A simplex has its centre inside iff each vertex is outside of the smallest sphere of the others:
        then it is on the same side of them as the centre. An edge always has."""
        stars = {}  # by simplex: link vertices on its smallest sphere, cells with all of theirs there, a facet; or None
        for c, cell in enumerate(self.cells):
            faces = [s for size in range(2, self.dimension + 2) for s in combinations(sorted(cell), size)]
            outside = {s: {p: self.outside(s, p) for p in cell if p not in s} for s in faces}
            for s in faces:
                if len(s) > 2 and any(outside[s[:i] + s[i + 1:]][p] <= 0 for i, p in enumerate(s)):
                    continue
                if min(outside[s].values(), default=0) < 0:
                    stars[s] = None
                star = stars.setdefault(s, [set(), [], None])
                if star:
                    zeros = [p for p, how in outside[s].items() if how == 0]
                    others = [p for p, how in outside[s].items() if how > 0]
                    star[0].update(zeros)
                    if not others:
                        star[1].append((c, zeros))
                    elif len(others) == 1:
                        star[2] = (c, cell.index(others[0]))
        self.records += [(*self.kind_of(s, *star), s) for s, star in stars.items() if star]

    def kind_of(self, simplex, zeros, cells, facet):
        """The kind and the contact set of a simplex that is stationary. In dimension 3, a and b of FC-CERT-04 are
        len(zeros) and len(cells). Here the simplex itself may be the cell that has all its vertices on the sphere."""
        contact = self.on_sphere[cells[0][0]] if cells else self.circle(*facet) if facet else simplex
        if self.dimension < 3 or len(simplex) > 2 or not cells:
            return ((1, R12, 2), (2, R23, 3), (3,))[len(simplex) - 2][len(zeros)], contact
        if len(zeros) == len(cells):
            return 3, contact
        link = [p for _, two in cells for p in two]
        a, b, c = self.t.edges([*simplex, *(p for p in link if link.count(p) == 1)])
        return R23 if dot(a, cross(b, c)) == 0 else R13, contact


# ---- Lists

WHOLE, STRING = "(?:0|[1-9][0-9]*+)", r'"[^"\\\x00-\x1f]*+"'
IDS = rf"\[(?:{WHOLE}(?:,{WHOLE})*+)?\]"
NUMBER = rf"(?:null|-?{WHOLE}(?:\.[0-9]++)?(?:[eE][+-]?[0-9]++)?)"


def pattern_of(shape):
    """A line with these keys in their order, and without a blank. One with a question mark may lack."""
    first, *others = ('"{0}":(?P<{0}>{1})'.format(key.rstrip("?"), value) for key, value in shape.items())
    marks = ["?" * key.endswith("?") for key in shape][1:]
    return re.compile(r"\{" + first + "".join(f"(?:,{one}){mark}" for one, mark in zip(others, marks)) + r"\}\n")


MADE_BY = dict.fromkeys(("version?", "commit?", "kernel?", "compiler?", "cgal?", "input_sha256?"), STRING)
COUNTS = {"points": WHOLE, "merged_duplicates": WHOLE, "critical": IDS,
          "regular_stationary": rf'\{{"1-2":{WHOLE},"1-3":{WHOLE},"2-3":{WHOLE}\}}',
          "classes": rf"\[(?:{IDS}(?:,{IDS})*+)?\]"}
HEADER = pattern_of({
    "format": '"flowcert-stationary-points"', "format_version": "1", **MADE_BY, "left_out?": IDS,
    **COUNTS, "centers?": '"double"|"none"', "morse_smale?": "true|false", "hull_volume?": STRING,
    "volumes?": STRING})
SETS = {"index": f"{WHOLE}|{IDS}", "kind": STRING, "contact": IDS}
EXACT = {"center": rf"\[{STRING},{STRING},{STRING}\]", "squared_distance": STRING}
DOUBLES = {"center_double": rf"\[{NUMBER},{NUMBER},{NUMBER}\]", "squared_distance_double": NUMBER}
RECORDS = {None: pattern_of(SETS | EXACT | DOUBLES), '"double"': pattern_of(SETS | DOUBLES), '"none"': pattern_of(SETS)}


def ids(values):
    return "[" + ",".join(map(str, values)) + "]"


def nearest_double(value):
    """The shortest decimal of the nearest double, without the sign of a zero; null where it would overflow."""
    try:
        return repr(value.numerator / value.denominator + 0.0)
    except OverflowError:
        return "null"


class List:
    """A list in a file, beside what it has to be. Values are compared as they are written, but doubles as numbers."""

    def __init__(self, path, triangulation, stationary):
        self.path, self.t, self.points, self.stationary = path, triangulation, triangulation.points, stationary

    def values(self, number, line, pattern):
        text = line.decode("utf-8", errors="backslashreplace")
        found = pattern.fullmatch(text)
        if not found:
            unknown = [key for key in re.findall(r'"(\w{1,40})":', text) if key not in pattern.groupindex]
            raise Undecodable(f"{self.path}:{number}: " + (f'the key "{unknown[0]}" is not proved' if unknown else
                                                           "cannot be decoded: not as compute writes it"))
        return {key: value for key, value in found.groupdict().items() if value is not None}

    def compare(self, number, found, expected):
        for key, right in expected.items():
            text = found.get(key, right)
            if key.endswith("_double"):
                text = re.sub("[^][,nul]+", lambda decimal: repr(float(decimal[0]) + 0.0), text)
            if text != right:
                raise Rejected(f"list refuted: line {number}: {key} is {text:.80}, and has to be {right:.80}")

    def header(self):
        points, counts = self.points, self.stationary.counts
        return {"input_sha256": f'"{points.sha256}"', "points": str(len(points.at)),
                "merged_duplicates": str(len(points.at) - len(points.distinct)), "critical": ids(counts[:4]),
                "regular_stationary": '{{"1-2":{},"1-3":{},"2-3":{}}}'.format(*counts[4:]),
                "classes": ids(map(ids, points.classes))}

    def record(self, kind, contact, simplex):
        toward, k = self.t.center(simplex)
        scale = 2 * k << self.points.shift
        center = [Fraction(2 * k * x + y, scale) for x, y in zip(self.points.at[simplex[0]], toward)]
        squared = Fraction(dot(toward, toward), scale * scale)
        return {"index": KINDS[kind], "kind": '"critical"' if kind < 4 else '"regular"', "contact": ids(contact),
                "center": ids(f'"{x}"' for x in center), "squared_distance": f'"{squared}"',
                "center_double": ids(map(nearest_double, center)), "squared_distance_double": nearest_double(squared)}

    def prove(self):
        """Reads the list line by line, and tells in sentences what is proved of it."""
        number, records = 1, iter(self.stationary.records)
        with open(self.path, "rb") as lines:
            head = self.values(1, next(lines, b""), HEADER)
            self.compare(1, head, self.header())
            pattern = RECORDS[head.get("centers")]
            for number, line in enumerate(lines, 2):
                found, record = self.values(number, line, pattern), next(records, None)
                if not record:
                    raise Rejected(f"list refuted: line {number}: a record more than there are stationary points")
                self.compare(number, found, self.record(*record))
        for _, contact, _ in records:
            raise Rejected(f"list refuted: line {number + 1}: missing, with the contact {ids(contact)[:80]}")
        others = [key for key in head if key not in {"format", "format_version", *self.header(), "centers"}]
        return [f"proved, line by line of {self.path}: {', '.join(pattern.groupindex)}",
                f"proved, header of {self.path}: {', '.join(key for key in [*COUNTS, 'input_sha256'] if key in head)}",
                f"not compared, header of {self.path}: {', '.join(others)}"]


# ---- The program


def prove(options):
    """What is proved, in sentences."""
    points, last = Points(options.scan), []
    if options.cells:
        triangulation = read_cells(options.cells, points)
    else:
        triangulation, digest = read_certificate(options.certificate, points)
        last = ["hash of the points: compared" if digest else "no hash of the points"]
    if triangulation.cells:
        triangulation.check_cells()
        triangulation.check_hull()
    if options.from_cells:
        Path(options.from_cells).write_bytes(encode(triangulation))
    stationary = StationaryPoints(triangulation)
    counts = "critical {} {} {} {}, regular 1-2: {}, 1-3: {}, 2-3: {}".format(*stationary.counts)
    return [f"proved: these {len(triangulation.cells)} cells are a Delaunay triangulation of {len(points.at)} points "
            f"({len(points.distinct)} different ones)",
            f"proved: all {len(stationary.records)} stationary points: {counts}",
            *(List(options.list, triangulation, stationary).prove() if options.list else []), *last]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", metavar="SCAN")
    parser.add_argument("certificate", metavar="CERTIFICATE", nargs="?")
    parser.add_argument("list", metavar="LIST", nargs="?")
    parser.add_argument("--cells", metavar="FILE", help="a plain list of cells, instead of a certificate")
    parser.add_argument("--from-cells", metavar="CERTIFICATE", help="where to write a certificate of these cells")
    options = parser.parse_args()
    if bool(options.cells) == bool(options.certificate) or options.from_cells and not options.cells:
        parser.error("needs either a certificate or --cells; --from-cells goes with --cells")
    sys.stdout.reconfigure(errors="backslashreplace")
    try:
        try:
            status, told = 0, "\n".join(prove(options))
        except Rejected as error:
            status, told = 1, str(error)
        print(told, flush=True)
        return status
    except (Undecodable, OSError, MemoryError) as error:
        print(str(error) or "there is not enough memory", file=sys.stderr)
        sys.stdout = None  # if it is full, it is not flushed once more
        return 2


if __name__ == "__main__":
    sys.exit(main())
