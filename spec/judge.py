#!/usr/bin/env python3
"""Judges any program that computes critical points, by the conformance vectors, without a build.

    judge.py --against 'my-program {in} {out}'        runs it on all vectors beside this file, and prints a table
    judge.py --against '...' --orbits-against 'my-orbits {in} {start} {out}'      asks for orbits, too
    judge.py --case duplicates-0003 --claim FILE      judges one claim

It judges the levels 1 to 4 of FC-CLAIM-19 (claims.md) and orbits, exactly: with fractions, never with a double.
It says in which profile (FC-CLAIM-22) the claim or the program conforms.
read_claim.py reads claims; what they say on level 5 has to be well formed, and is not judged.
Exit status: 0 if nothing is negative, 1 if something is, 2 for what cannot be used.
"""
import argparse, contextlib, hashlib, itertools, json, os, re, resource, shlex, signal, struct, subprocess, sys
import tempfile
from collections import Counter
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

sys.dont_write_bytecode = True  # beside this file
from read_claim import KINDS, Literal, Unreadable, hexadecimal, ids, nearest_double, number, parse, read_claim
from read_claim import require, roots_differ_by, rounds_alike

sys.set_int_max_str_digits(0)
HERE = Path(__file__).parent
VERSION = "1.2"  # of the specification
TINY = Fraction(1, 2**44)  # what rounding explains (FC-CLAIM-05)
LARGEST_STATED = 1e-6  # the greatest tolerance with which decimals are said to conform (FC-CLAIM-23)
CONFORMS, DETERMINED, PERTURBED, FAILS = "conforms", "conforms where determined", "perturbed", "fails"
GOOD = [CONFORMS, DETERMINED, PERTURBED]
NEGATIVE = [FAILS, "accepted", "refused", "crashed", "timed out", "unreadable"]


# ---- Geometry


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sign_of_det(a, b, c):
    found = dot(cross(a, b), c)
    return (found > 0) - (found < 0)


def squared_distance(a, b):
    return dot(minus(a, b), minus(a, b))


def sphere_through(points):
    """The smallest sphere through the first of the points that span their affine hull: centre, squared radius."""
    p, basis = points[0], []
    for v in (minus(q, points[0]) for q in points[1:]):
        if not basis or (len(basis) == 1 and any(cross(basis[0], v))) or (len(basis) == 2 and sign_of_det(*basis, v)):
            basis.append(v)
    if len(basis) < 2:
        center = tuple(x + y / 2 for x, y in zip(p, basis[0] if basis else minus(p, p)))
        return center, squared_distance(p, center)
    a, b, c = basis if len(basis) == 3 else (*basis, cross(*basis))
    squares = [dot(a, a), dot(b, b), dot(c, c) if len(basis) == 3 else 0]
    normals = cross(b, c), cross(c, a), cross(a, b)
    center = tuple(x + sum(s * n[k] for s, n in zip(squares, normals)) / (2 * dot(cross(a, b), c))
                   for k, x in enumerate(p))
    return center, squared_distance(p, center)


def in_hull(points, x):
    """Whether x is in the convex hull of points that are equally far from x."""
    v = [minus(p, x) for p in points]
    opposite = {tuple(-x for x in a) for a in v}
    if any(not any(a) or a in opposite for a in v):
        return True
    for a, b, c in itertools.combinations(v, 3):
        n = cross(a, b)
        if not dot(n, c) and dot(n, cross(b, c)) > 0 and dot(n, cross(c, a)) > 0:
            return True
    return any({sign_of_det(b, c, d), sign_of_det(a, d, c), sign_of_det(a, b, d), sign_of_det(a, c, b)} in ({1}, {-1})
               for a, b, c, d in itertools.combinations(v, 4))


def in_interior(points, x):
    """Whether x, in the hull of points that are equally far from it, is on no supporting plane."""
    v = [minus(p, x) for p in points]
    planes = [(a, b) for a, b in itertools.combinations(v, 2) if any(cross(a, b))]
    return bool(planes) and all({-1, 1} <= {sign_of_det(*plane, a) for a in v} for plane in planes)


def nearest_in_hull(points, center):
    """The point of the hull of points on one sphere that is nearest to its centre: that of their smallest ball."""
    for some in itertools.chain.from_iterable(itertools.combinations(points, size) for size in range(1, 5)):
        x, squared = sphere_through(some)
        if in_hull(some, x) and all(squared_distance(p, x) <= squared for p in points):
            return x
    raise AssertionError("every set of points has a smallest ball")


# ---- The truth: a case of the vectors


class Truth:
    def __init__(self, case):
        self.rows = [tuple(float.fromhex(word) for word in row) for row in case["points"]]
        self.points = [tuple(map(Fraction, row)) for row in self.rows]
        classes = {}
        for row, p in enumerate(self.points):
            classes.setdefault(p, []).append(row)
        self.name = [classes[p][0] for p in self.points]
        self.classes = [rows for rows in classes.values() if len(rows) > 1]
        self.records = [self.record_of(k, one) for k, one in enumerate(case["expected"]["stationary"])]
        self.at = {record.contact: record for record in self.records}

    @staticmethod
    def record_of(k, value):
        index, hull = value["index"] if isinstance(value["index"], list) else [value["index"]] * 2
        center, squared = tuple(map(Fraction, value["center"])), Fraction(value["squared_distance"])
        largest = max(map(abs, center)) ** 2
        return SimpleNamespace(
            k=k, index=index, hull=hull, critical=index == hull, contact=tuple(value["contact"]), center=center,
            squared=squared, told=value.get("incidences", {}), is_simplex=len(value["contact"]) == hull + 1,
            allowed=squared or largest, rounding=TINY**2 * max(squared, largest))

    def digest(self):
        return hashlib.sha256(b"".join(struct.pack("<3d", *(x + 0.0 for x in row)) for row in self.rows)).hexdigest()

    def limits(self, record):
        return [None if one is None else self.at[tuple(one)] for one in record.told["limits"]]

    def names(self, rows):
        return tuple(sorted({self.name[row] for row in rows}))

    def where(self, names):
        return [self.points[name] for name in names]

    def side(self, plane, name):
        a, b, c, d = self.where([*plane[:3], name])
        return sign_of_det(minus(b, a), minus(c, a), minus(d, a))

    def dimension(self, names):
        """Of the hull of samples of one sphere."""
        return len(names) - 1 if len(names) < 4 else 3 if any(self.side(names, name) for name in names[3:]) else 2

    def placed(self, names):
        """The record with this contact set, or with its centre and a larger one, and how it fits (FC-CLAIM-02)."""
        if names in self.at:
            return self.at[names], "whole"
        larger = [one for one in self.records if names and set(names) < set(one.contact)]
        center = sphere_through(self.where(names))[0] if larger else None
        for record in larger:
            if record.center == center:
                is_part = len(names) == record.hull + 1 and self.dimension(names) == record.hull
                return record, "part" if is_part else "other"
        return None, None


# ---- The judge. `fit` says how a claimed contact set fits its record: "whole", "part", "other", or "position".

# How a stationary point at a claimed position fits, from good to bad. `made`: a perturbation may make it of the point.
RIGHT, MADE, WRONG_VALUE, WRONG_MADE, WRONG_INDEX = range(5)


def maximum_matching(choices):
    """The partner of each that has one, of the partners that each may have, by augmenting paths (FC-CLAIM-24)."""
    owner = {}

    def find_own(k, tried):
        for one in choices[k]:
            if one not in tried:
                tried.add(one)
                if one not in owner or find_own(owner[one], tried):
                    owner[one] = k
                    return True
        return False

    for k, some in enumerate(choices):
        free = [one for one in some if one not in owner]
        owner.update({free[0]: k} if free else {})
    for k in sorted(set(range(len(choices))) - set(owner.values())):
        find_own(k, set())
    return {k: one for one, k in owner.items()}


class Judge:
    def __init__(self, truth, claim, tolerance, highest):
        self.truth, self.claim, self.tolerance, self.highest = truth, claim, Fraction(tolerance), highest
        self.findings, self.undecided, self.judged = [], False, {1}
        self.perturbed = {}  # by record: the claims that a perturbation makes of it

    def find(self, level, reason, clause, point=None, permitted=False, contact=()):
        line, contact = (point.line, point.contact) if point else (None, contact)
        self.findings.append({"level": level, "reason": reason, "permitted": permitted, "clause": clause, "line": line,
                              "contact": list(contact)})

    def run(self):
        self.check_form()
        if self.highest >= 2:
            self.check_points()
            self.judged |= {2} if self.claim.points else set()
            self.judged |= {3} if self.highest >= 3 else set()
        if self.highest >= 4 and any([self.check_incidences(point) for point in self.claim.points]):
            self.judged.add(4)
        self.findings = [one for one in self.findings if one["level"] <= self.highest]
        self.findings.sort(key=lambda f: (f["permitted"], f["level"], f["line"] or float("inf"), f["contact"]))
        verdicts = [FAILS if not one["permitted"] else PERTURBED if one["reason"] == "symbolic-perturbation" else
                    DETERMINED for one in self.findings]
        return max(verdicts, key=[*GOOD, FAILS].index, default=CONFORMS)

    # ---- Level 1 (FC-CLAIM-01, 12)

    def check_form(self):
        truth, points, indices = self.truth, self.claim.points, self.claim.indices
        listed = Counter((point.index, point.hull) for point in points)
        self.counts = [listed[k, None] for k in range(4)]
        head = {"critical": self.counts, **self.claim.head}
        head["critical"] = [n if k in indices else self.counts[k] for k, n in enumerate(head["critical"])]
        for key, value, reason, clause in [
                ("points", len(truth.rows), "wrong-counts", "FC-IN-03"),
                ("classes", truth.classes, "malformed", "FC-IN-03"),
                ("merged_duplicates", len(truth.rows) - len(set(truth.name)), "wrong-counts", "FC-IN-03"),
                ("input_sha256", truth.digest(), "malformed", "FC-CLAIM-01"),
                ("critical", self.counts, "wrong-counts", "FC-CLAIM-01"),
                ("regular_stationary", [listed[kind] for kind in KINDS], "wrong-counts", "FC-CLAIM-01")]:
            if head.get(key, value) != value:
                self.find(1, reason, clause)
        for point in points:
            point.names, point.record, point.fit = truth.names(point.contact), None, None
            point.right, point.several = False, False
            lists = [point.contact, point.samples or [], *point.lists]
            is_asked = point.hull is not None or point.index in indices
            point.formed = is_asked and all(point.lists) and all(len(set(one)) == len(one) for one in lists)
            if not point.formed:
                self.find(1, "malformed", "FC-CLAIM-01" if is_asked else "FC-CLAIM-12", point)

    # ---- Which stationary point is meant (FC-CLAIM-05, 24)

    @staticmethod
    def rank(point, record):
        """0: of the claimed index or kind. 1: regular, and a perturbation may make such a point of it. 2: neither."""
        if (point.index, point.index if point.hull is None else point.hull) == (record.index, record.hull):
            return 0
        return 1 if point.hull is None and record.index <= point.index <= record.hull else 2

    def near(self, point):
        """The stationary points at which a position is right: how they fit, the squared distance, and their place."""
        within, nearly = [], []
        for record in self.truth.records:
            match = self.match_position(point.center, record)
            if match != "off":
                wrong = bool(self.wrong_values(point, record))
                fit = (WRONG_VALUE if wrong else RIGHT, WRONG_MADE if wrong else MADE, WRONG_INDEX)
                away = squared_distance([value for value, _ in point.center], record.center)
                (nearly if match == "rounding" else within).append((fit[self.rank(point, record)], away, record.k))
        return sorted(within or nearly)

    def place(self, points):
        """As many claims as possible get a stationary point of their own (FC-CLAIM-24)."""
        near, choices = [], []
        for point in points:
            point.record, point.fit = self.truth.placed(point.names)
            is_own = point.record and point.fit != "other" and self.rank(point, point.record) == 0
            near.append([] if point.names else self.near(point))
            choices.append([point.record.k] if is_own else [one[2] for one in near[-1] if one[0] == RIGHT])
        partner = maximum_matching(choices)
        taken = set(partner.values())
        for k, (point, found) in enumerate(zip(points, near)):
            if found:
                made = [record for fit, _, record in found if fit == MADE]
                free = [record for fit, _, record in found if fit == WRONG_VALUE and record not in taken]
                chosen = partner[k] if k in partner else [*made, *free, found[0][2]][0]
                taken |= set() if made else {chosen}
                point.record, point.fit, point.several = self.truth.records[chosen], "position", len(choices[k]) > 1
                if len(found) > 1:
                    self.find(2, "ambiguous", "FC-CLAIM-05", point, permitted=True)

    # ---- Level 2: positions and distances (FC-CLAIM-05), and what is no stationary point (FC-CRIT-05)

    def match_position(self, claimed, record, center=None):
        pairs, off = list(zip(claimed, center or record.center)), [0, 0]
        if all(value == true if exact else rounds_alike(value, true) for (value, exact), true in pairs):
            return "right"
        for (value, exact), true in pairs:
            off[exact] += (value - true) ** 2
        if not off[True] and off[False] <= self.tolerance**2 * record.allowed:
            return "right"
        return "rounding" if sum(off) <= record.rounding else "off"

    def match_squared(self, claimed, record):
        value, exact = claimed
        allowed = self.tolerance**2 * record.allowed
        if value == record.squared or (not exact and (rounds_alike(value, record.squared) or
                                                      roots_differ_by(value, record.squared, allowed))):
            return "right"
        return "rounding" if roots_differ_by(value, record.squared, record.rounding) else "off"

    def wrong_values(self, point, record):
        """How what is wrong of a claimed position and distance is, with its clause."""
        found = [("FC-NUM-02", claimed and self.match_position([claimed], record, [true]))
                 for claimed, true in zip(point.doubles, record.center)]
        if point.squared_double != "none":
            match = point.squared_double and self.match_squared(point.squared_double, record)
            found.append(("FC-NUM-02", match or ("right" if nearest_double(record.squared) is None else "off")))
        if point.center:
            found.append(("FC-OUT-01", self.match_position(point.center, record)))
        squared = point.distance and (point.distance[0] ** 2, point.distance[1])
        found += [("FC-OUT-01", self.match_squared(one, record)) for one in (point.squared, squared) if one]
        return [(clause, match) for clause, match in found if match != "right"]

    def check_values(self, point):
        for clause, match in self.wrong_values(point, point.record):
            self.find(2, "rounding" if match == "rounding" else "wrong-position", clause, point)

    def check_stray(self, point):
        """The first condition of FC-CRIT-05 that does not hold."""
        if not point.names:
            return self.find(2, "wrong-position", "FC-CRIT-01", point)
        contact = self.truth.where(point.names)
        center, squared = sphere_through(contact)
        distances = {name: squared_distance(self.truth.points[name], center) for name in self.truth.name}
        own, nearest = [distances[name] for name in point.names], min(distances.values())
        allowed = TINY**2 * max(squared, max(map(abs, center)) ** 2)
        if any(one != squared for one in own):
            reason, letter, near = "not-cospherical", "a", all(roots_differ_by(one, squared, allowed) for one in own)
        elif nearest < squared:
            reason, letter, near = "ball-not-empty", "b", roots_differ_by(nearest, squared, allowed)
        elif list(distances.values()).count(nearest) > len(own):
            reason, letter, near = "contact-incomplete", "c", False
        else:
            reason, letter = "outside-hull", "d"
            near = squared_distance(nearest_in_hull(contact, center), center) <= allowed
        return self.find(2, "rounding" if near else reason, f"FC-CRIT-05 ({letter})", point)

    # ---- Levels 2 and 3 (FC-CLAIM-02 to 04)

    def check_points(self):
        formed = sorted((point for point in self.claim.points if point.formed), key=lambda point: not point.names)
        self.place(formed)
        here = {record.k: [] for record in self.truth.records}
        for point in sorted(formed, key=lambda point: point.line):
            if point.record is None:
                self.check_stray(point)
            else:
                here[point.record.k].append(point)
        for record in self.truth.records:
            (self.check_critical if record.critical else self.check_regular)(record, here[record.k])
        n = self.counts
        if self.claim.indices == {0, 1, 2, 3} and n[0] - n[1] + n[2] - n[3] != bool(self.truth.rows):
            self.find(3, "wrong-counts", "FC-INV-01")

    def check_own(self, record, here):
        """Claims that are not what a perturbation makes: one is right."""
        first = None
        for point in here:
            is_own = self.rank(point, record) == 0
            if point.fit == "other" and (record.critical or is_own):
                self.find(2, "contact-incomplete", "FC-CRIT-05 (c)", point)
            elif not is_own:
                self.find(3, "wrong-index", "FC-CRIT-02" if record.critical else "FC-CRIT-03", point)
            elif first:
                self.find(3, "claimed-twice", "FC-CRIT-06", point)
            else:
                first, point.right = point, True
                if point.fit == "part":
                    self.find(2, "spanning-part", "FC-CLAIM-02", point, permitted=True)
        return first

    def check_critical(self, record, here):
        is_plain = len(here) == 1 and here[0].fit != "other" and self.rank(here[0], record) == 0
        made, impossible, again = ([], [], []) if is_plain else self.sorted_claims(record, here)
        is_made = made and not impossible and not again and self.makes(record, made)
        for point in here:
            if is_made or point.fit != "other":
                self.check_values(point)
        if is_made:
            return self.accept_perturbed(record, made)
        self.check_own(record, here)
        is_addressed = any(point.fit != "other" or self.rank(point, record) == 0 for point in here)
        if not is_addressed and record.index in self.claim.indices:
            reason = "missing" if record.is_simplex else "missed-by-cluster"
            self.find(3, reason, "FC-CLAIM-03", contact=record.contact)
        return None

    def check_regular(self, record, here):
        for point in here:
            self.check_values(point)
        first = self.check_own(record, [point for point in here if point.hull is not None])
        made, impossible, again = self.sorted_claims(record, [point for point in here if point.hull is None])
        for point in again:
            self.find(3, "claimed-twice", "FC-CRIT-06", point)
        if made and not first and self.makes(record, made):
            self.accept_perturbed(record, made)
            made = []
        for point in impossible + made:
            self.find(2, "collision-as-critical", "FC-CRIT-03", point)
        says_of_regular = "regular_stationary" in self.claim.head or any(one.hull for one in self.claim.points)
        if not here and says_of_regular:
            self.find(3, "symbolic-perturbation", "FC-CLAIM-04", permitted=True, contact=record.contact)

    # ---- What a perturbation makes (FC-CLAIM-04, 12)

    def accept_perturbed(self, record, made):
        self.perturbed[record.k] = made
        self.undecided = self.undecided or not record.is_simplex
        for point in made:
            point.right = True
            self.find(2, "symbolic-perturbation", "FC-CLAIM-04", point, permitted=True)

    def most(self, record, index):
        """How many points of an index a perturbation can make, where that has a bound: parts with x in their hull."""
        if index > 1 and not record.is_simplex:
            return len(self.claim.points) + len(record.contact)
        parts = itertools.combinations(self.truth.where(record.contact), index + 1)
        return sum(in_hull(part, record.center) for part in parts)

    def is_face(self, record, names):
        """Whether they are the vertices of a polygon that is a face of the hull of C(x), of dimension 3."""
        if record.hull < 3 or self.truth.dimension(names) != 2:
            return False
        sides = {name: self.truth.side(names, name) for name in record.contact}
        return len(set(sides.values()) - {0}) == 1 and tuple(n for n, side in sides.items() if not side) == names

    def kept_polygon(self, record, names):
        """The face in which an index-3 point of many samples has all of them but one."""
        rests = [tuple(one for one in names if one != apex) for apex in names]
        return next((rest for rest in rests if self.is_face(record, rest)), None)

    def is_on_face(self, record, names):
        """Whether samples with x in their hull are on a proper face of the hull of C(x)."""
        if len(names) == 2:
            return not record.critical
        sides = {self.truth.side(names, name) for name in record.contact} - {0}
        return record.hull == 3 and self.truth.dimension(names) == 2 and len(sides) < 2

    def can_make(self, record, point):
        """Conditions (a) and (b)."""
        names, index = point.names, point.index
        if point.hull is not None or not names:
            return point.hull is None and self.most(record, index) > 0
        is_face = index == record.hull if names == record.contact else \
            index == 2 and self.is_face(record, names) or index == 3 and self.kept_polygon(record, names) is not None
        fits_index = len(names) == index + 1 or is_face
        return fits_index and set(names) <= set(record.contact) and in_hull(self.truth.where(names), record.center)

    def sorted_claims(self, record, here):
        """Claims that a perturbation may make, those that none does, and those that are there already."""
        made, impossible, again = [], [], []
        for point in here:
            same = [one.names for one in made if one.index == point.index]
            if not self.can_make(record, point):
                impossible.append(point)
            elif len(same) >= self.most(record, point.index) or (point.names and point.names in same):
                again.append(point)
            else:
                made.append(point)
        return made, impossible, again

    def makes(self, record, made):
        """Conditions (c) to (h)."""
        named = [point for point in made if point.names]
        numbers = [[sum(point.index == k for point in made)] if k in self.claim.indices else
                   range(self.most(record, k) + 1) for k in (1, 2, 3)]
        return len({point.names for point in named}) == len(named) and self.fit_together(record, named) and \
            any(self.is_possible(record, *some) for some in itertools.product(*numbers))

    def is_possible(self, record, *numbers):
        """Whether there can be such numbers of points of the indices 1, 2 and 3."""
        right = 0 if not record.critical else 1 if record.index == 2 else -1
        if numbers[1] - numbers[0] - numbers[2] != right or (record.critical and not numbers[record.index - 1]):
            return False
        if not record.is_simplex or (record.index, record.hull) != (1, 3) or numbers[1] != 1:
            return True
        # Of two triangles at the edge there is one. What there is beside it tells the tetrahedron's angle at the edge.
        contact = self.truth.where(record.contact)
        edge = next(one for one in itertools.combinations(contact, 2) if in_hull(one, record.center))
        a, (r, s) = minus(*edge), (minus(p, record.center) for p in contact if p not in edge)
        cosine = dot(r, s) * dot(a, a) - dot(r, a) * dot(s, a)
        return cosine >= 0 if numbers[0] else cosine <= 0

    def fit_together(self, record, made):
        """Conditions (f) to (h), of claims with contact sets."""
        others = [point for point in made if (point.names, point.index) != (record.contact, record.hull)]
        if sum(in_interior(self.truth.where(point.names), record.center) for point in others) > 1:
            return False
        are_on_faces = all(self.is_on_face(record, point.names) for point in others)
        if len(others) < len(made) or (are_on_faces and 3 not in self.claim.indices):
            return are_on_faces
        return len({point.names if point.index == 2 else self.kept_polygon(record, point.names)
                    for point in others if len(point.names) > point.index + 1}) < 2

    # ---- Level 4 (FC-CLAIM-06, 07, 09)

    def check_incidences(self, point):
        """Whether there was something to judge."""
        if not point.right or point.several:
            return False
        indices, is_made = self.claim.indices, point.record.k in self.perturbed
        has_samples = point.samples is not None and 0 in indices
        has_boundary = point.boundary is not None and 1 in indices and not is_made
        has_targets = point.targets is not None and (point.index == 3 or point.index + 1 in indices) and not is_made
        if has_samples:
            names = self.truth.names(point.samples)
            if not (names == point.names if point.names else self.truth.placed(names)[0] is point.record):
                self.find(4, "wrong-incidence", "FC-FLOW-07", point)
        if has_boundary:
            self.check_boundary(point)
        if has_targets and point.index < 3:
            (self.check_limits if point.index == 2 else self.check_above)(point)
        elif has_targets:
            for _ in filter(None, point.targets):
                self.find(4, "wrong-incidence", "FC-FLOW-03", point)
        return has_samples or has_boundary or has_targets

    def target(self, rows):
        """The stationary point that is named (None: infinity, or none), and how it fits."""
        names = self.truth.names(rows or [])
        record, fit = self.truth.placed(names) if names else (None, "whole")
        return record, "made" if record and fit != "whole" and self.is_made(record, names) else fit

    def is_made(self, record, names, index=None):
        return any(index in (None, one.index) and one.names in ((), names) for one in self.perturbed.get(record.k, []))

    def check_above(self, point):
        """What is above a sample, or an index-1 point."""
        record, reasons, wrong = point.record, set(), False
        is_edge, contact = point.index == 1, list(point.record.contact)
        above = [one for one in self.truth.records if (contact in one.told.get("ends", []) if is_edge else
                                                       (one.index, one.hull) == (1, 1) and contact[0] in one.contact)]
        missing = {one.k for one in above}
        seen, says_infinity = set(), is_edge and not above and None in point.targets
        for rows in point.targets:
            there, fit = self.target(rows)
            if there is None:
                wrong = wrong or not (rows is None and says_infinity)
            elif there.k not in seen:
                seen.add(there.k)
                is_owed = there.k in missing and fit != "other"
                why = {"part": "spanning-part", "made": "symbolic-perturbation"}.get(fit) if is_owed else \
                    self.why_above(there, record, rows)
                wrong = wrong or not (is_owed or why)
                missing -= {there.k}
                reasons.add(why)
        excused = {k: "symbolic-perturbation" if k in self.perturbed else "tie-break" for k in missing
                   if is_edge and (k in self.perturbed or self.truth.records[k].told["boundary"] is None)}
        if wrong or missing - set(excused):
            self.find(4, "wrong-incidence", "FC-CHAIN-01" if is_edge else "FC-FLOW-07", point)
        elif reasons := {*reasons, *excused.values()} - {None}:
            worst = max(reasons, key=["spanning-part", "tie-break", "symbolic-perturbation"].index)
            clause = "FC-CLAIM-04" if not is_edge else "FC-CLAIM-02" if worst == "spanning-part" else "FC-CLAIM-09"
            self.find(4, worst, clause, point, permitted=True)
        if says_infinity and None not in (limits := self.truth.limits(record)):
            may = any(self.may_end(None, one) for one in limits)
            self.find(4, *(("symbolic-perturbation", "FC-CLAIM-07") if may else ("wrong-incidence", "FC-CLAIM-06")),
                      point, permitted=may)

    def why_above(self, there, record, rows):
        """Why it may be named above a sample or an index-1 point, though it is not above that."""
        names = self.truth.names(rows)
        if record.index == 0:
            is_edge = record.contact[0] in names and self.is_made(there, names, 1)
            return "symbolic-perturbation" if is_edge else None
        if there.squared <= record.squared:
            return None
        if not there.critical or there.k in self.perturbed:
            return "symbolic-perturbation"
        return "tie-break" if there.index == 2 and there.told["boundary"] is None else None

    def check_limits(self, point):
        true, whole = self.truth.limits(point.record), point.record.contact
        sides = map(self.truth.where, ((point.names or whole)[:3], whole[:3]))
        if dot(*(cross(minus(q, p), minus(r, p)) for p, q, r in sides)) < 0:
            true.reverse()
        limits, fits = zip(*map(self.target, point.targets)) if point.targets else ((), ())
        is_same = list(limits) == true if point.by_side else {*map(id, limits)} == {*map(id, true)}
        if is_same and not {"other", "made", None} & {*fits}:
            if "part" in fits:
                self.find(4, "spanning-part", "FC-CLAIM-02", point, permitted=True)
        elif not {"other", None} & {*fits} and self.may_be_limits(limits, true, point.by_side):
            self.find(4, "symbolic-perturbation", "FC-CLAIM-07", point, permitted=True)
        else:
            self.find(4, "wrong-incidence", "FC-FLOW-07", point)

    def may_be_limits(self, limits, true, by_side):
        some = [one for k, one in enumerate(limits) if one not in limits[:k]]
        orders = ([true] if by_side else [true, true[::-1]]) if 1 <= len(some) <= 2 else []
        return any(self.may_end(some[0], a) and self.may_end(some[-1], b) for a, b in orders)

    def may_end(self, target, true):
        """Whether a perturbation can make an orbit that ends at `true` end at the target."""
        if target is true or true is None:
            return target is true
        if true.critical:
            return true.index == 2 and any(self.may_end(target, one) for one in self.truth.limits(true))
        return target is None or (target.hull >= 2 and target.squared > true.squared)

    def check_boundary(self, point):
        record, named, degrees, has_regular = point.record, set(), Counter(), False
        for rows in point.boundary:
            names = self.truth.names(rows)
            edge = self.truth.placed(names)[0]
            made = edge is not None and self.is_made(edge, names, 1)
            if edge is None or len(names) != 2 or not (edge.index == 1 or made) or \
                    edge.squared >= record.squared or edge.contact in named:
                return self.find(4, "wrong-incidence", "FC-CHAIN-01", point)
            named.add(edge.contact)
            has_regular = has_regular or made or not edge.critical
            degrees.update(names)
        told = record.told["boundary"]
        if told is not None and named == set(map(tuple, told)):
            return None
        if told is not None or any(n % 2 for n in degrees.values()):
            return self.find(4, "wrong-incidence", "FC-CHAIN-01", point)
        # The vectors break no ties, so it is not judged which of the cycles is claimed.
        return has_regular and self.find(4, "symbolic-perturbation", "FC-CLAIM-09", point, permitted=True)


# ---- Orbits (FC-FLOW-01, 02, FC-CLAIM-08, formats/orbit.md)

# The types that exist (FC-FLOW-02).
SEGMENT_TYPES = {f"{way}-{end}" for way, ends in [
    ("V-E", ["V", "inf"]), ("E-E", ["V", "inf"]), ("V-F", ["V", "E", "inf"]), ("E-F", ["V", "E", "inf"]),
    ("F-F", ["V", "E", "inf"]), ("C-C", ["V", "E", "F", "inf"])] for end in ends}


def rationals(values, count=3):
    require(isinstance(values, list) and len(values) == count, f"not {count} numbers: {values}")
    require(all(isinstance(one, str) for one in values), f"no rational in a string: {values}")
    found = [number(one, plain_is_exact=True) for one in values]
    require(all(exact for _, exact in found), f"a decimal: {values}")
    return tuple(value for value, _ in found)


def read_segment(value):
    require(isinstance(value["type"], str), "a type that is no string")
    contacts = [None if value.get(key) is None else sorted(ids(value[key]))
                for key in ("start_contact", "crossed_contact", "end_contact")]
    end = None if value["end"] is None else rationals(value["end"])
    return [value["type"], rationals(value["driver"]), end, *contacts]


def read_orbit(data):
    require(data is not None, "there is no answer, or one that is too large")
    try:
        value = parse(data.decode("utf-8-sig"))
        require(isinstance(value["segments"], list), "'segments' is no array")
        segments, limit = [read_segment(one) for one in value["segments"]], value["limit"]
        if limit["kind"] == "infinity":
            return segments, None
        pair = limit["index"] if isinstance(limit["index"], list) else [limit["index"]] * 2
        is_right = [one.text in ("0", "1", "2", "3") for one in pair]
        require(is_right == [True, True], f"no index, 0 to 3, and no pair of them: {pair}")
        position, (squared,) = rationals(limit["position"]), rationals([limit["squared_distance"]], 1)
        return segments, [limit["kind"], limit["index"], position, sorted(ids(limit["contact"])), squared]
    except (AttributeError, TypeError, KeyError, UnicodeDecodeError) as error:
        raise Unreadable(f"not as the format says: {error!r}") from error


class Flow:
    """The flow of the samples of a case, and claimed orbits."""

    def __init__(self, truth):
        self.truth, self.samples = truth, {name: truth.points[name] for name in truth.name}

    def contact(self, x):
        distances = {name: squared_distance(p, x) for name, p in self.samples.items()}
        return [name for name, one in distances.items() if one == min(distances.values())]

    def letter(self, contact):
        return "CFEV"[self.truth.dimension(contact)] if contact else "inf"

    def segment(self, x, driver, u):
        """The flow segment from x in the direction u, as read_segment has it."""
        contact = self.contact(x)
        most = max(dot(u, self.samples[name]) for name in contact)
        crossed = [name for name in contact if dot(u, self.samples[name]) == most]
        p = self.samples[crossed[0]]
        times = [(squared_distance(q, x) - squared_distance(p, x)) / (2 * dot(u, minus(q, p)))
                 for q in self.samples.values() if dot(u, minus(q, p)) > 0]
        end = tuple(a + min(times) * b for a, b in zip(x, u)) if times else None
        after = self.contact(end) if times else None
        return ["-".join(map(self.letter, (contact, crossed, after))), driver, end, contact, crossed, after]

    def orbit(self, x):
        segments = []
        while x is not None:
            contact = tuple(self.contact(x))
            driver = nearest_in_hull(self.truth.where(contact), x)
            if driver == x:
                one = self.truth.at[contact]
                index = Literal(str(one.index)) if one.critical else [Literal(str(one.index)), Literal(str(one.hull))]
                return segments, ["critical" if one.critical else "regular", index, x, list(contact), one.squared]
            segments.append(self.segment(x, driver, minus(x, driver)))
            x = segments[-1][2]
        return segments, None

    @staticmethod
    def is_same(claimed, true, is_arrival_free=False):
        """Whether a segment is the true one. It may come to a regular stationary point in another way."""
        if not is_arrival_free:
            return all(one == other or (one is None and k > 2) for k, (one, other) in enumerate(zip(claimed, true)))
        kind, end_contact = claimed[0], claimed[5]
        is_arrival = kind in SEGMENT_TYPES and kind[:4] == true[0][:4] and kind[4:] != "inf"
        is_between = end_contact is None or set(true[4]) <= set(end_contact) <= set(true[5])
        return is_arrival and is_between and Flow.is_same([true[0], *claimed[1:5], None], true)

    def is_permitted(self, claimed, true):
        """Whether an orbit ends as the true one, or goes on at each regular stationary point where that ends."""
        (ours, limit), (theirs, end), count = claimed, true, len(true[0])
        if end is None or end[0] != "regular" or len(ours) < count:
            return False
        if not all(self.is_same(*both, k == count) for k, both in enumerate(zip(ours, theirs), 1)):
            return False
        if len(ours) == count:
            return limit == end
        y, (kind, driver, to, start, _, after) = end[2], ours[count]
        if to is None:  # infinity does not tell the direction
            is_leaving = kind in SEGMENT_TYPES and kind[0] == self.letter(end[3]) and kind[4:] == "inf" and driver == y
            return is_leaving and start in (None, end[3]) and not after and limit is None and len(ours) == count + 1
        _, _, reached, _, crossed, _ = first = self.segment(y, y, minus(to, y))
        if to != reached or not in_hull(self.truth.where(crossed), y):
            return False
        more, end = self.orbit(to)
        return self.verdict((ours[count:], limit), ([first, *more], end)) != FAILS

    def verdict(self, claimed, true):
        is_end_same = len(claimed[0]) == len(true[0]) and claimed[1] == true[1]
        return CONFORMS if is_end_same and all(map(self.is_same, claimed[0], true[0])) else \
            PERTURBED if self.is_permitted(claimed, true) else FAILS


# ---- Profiles (FC-CLAIM-22). Of each part it is known whether it is told (True), or left out (False), or whether there
# is nothing to tell of it (None).


def profile_of(claim, highest):
    saddles = [point for point in claim.points if point.hull is None and point.index == 2]
    told = {"points": highest >= 3, "U2": False, "S2": False, "orbits": None}
    if highest >= 4 and claim.indices == {0, 1, 2, 3}:
        told["U2"] = all(point.targets is not None for point in saddles) if saddles else None
        told["S2"] = all(point.boundary is not None for point in saddles) if saddles else None
    numbers = [one for point in claim.points for one in [*(point.center or []), point.squared, point.distance] if one]
    return {"parts": told, "indices": claim.indices, "exact": all(exact for _, exact in numbers)}


def statement(verdict, profiles, tolerance):
    """What is said of claims. None if nothing is told, or decimals may be too far off (FC-CLAIM-23)."""
    if verdict == FAILS:
        return f"does not conform to {VERSION}"
    states = {part: [profile["parts"][part] for profile in profiles] for part in ("points", "U2", "S2", "orbits")}
    parts = [part for part, told in states.items() if True in told and False not in told]
    indices = {0, 1, 2, 3}.intersection(*(profile["indices"] for profile in profiles))
    if parts[:1] == ["points"] and len(indices) < 4:
        parts[:1] = [f"points of index {', '.join(map(str, sorted(indices)))}"] if indices else []
    is_exact = all(profile["exact"] for profile in profiles)
    if not parts or (tolerance > LARGEST_STATED and not is_exact):
        return None
    words = {CONFORMS: "conforms to", DETERMINED: "conforms where determined to", PERTURBED: "is perturbed under"}
    grade = "exact" if is_exact else f"approximate within {tolerance!r}"
    return f"{words[verdict]} {VERSION}, {' + '.join(parts)}, {grade}"


# ---- Commands

LIMITS = [(resource.RLIMIT_AS, (4096 << 20,) * 2), (resource.RLIMIT_FSIZE, (64 << 20,) * 2)]


def points_text(case, as_they_are):
    def word_of(word):
        try:
            return word if as_they_are else repr(float(hexadecimal(word)))
        except Unreadable:
            return word

    lines = [" ".join(map(word_of, row)) + "\n" for row in case.get("points", [])]
    return case.get("text", "".join(lines) or "# no points\n")


def run_command(command, text, seconds, start="1,0,0"):
    """How it ends, what it answers, and what it said: an outcome or an exit status, bytes, and a line."""
    with tempfile.TemporaryDirectory(prefix="judge-") as folder:
        points, claim, said, log = (Path(folder, name) for name in ("points.xyz", "claim", "stdout", "stderr"))
        points.write_text(text, newline="")
        places = {"{in}": str(points), "{out}": str(claim), "{start}": start}
        order = re.sub(r"\{(?:in|out|start)\}", lambda place: shlex.quote(places[place[0]]), command)
        with open(said, "wb") as out, open(log, "wb") as errors:
            run = subprocess.Popen(["/bin/sh", "-c", order], cwd=folder, stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=errors, start_new_session=True,
                                   preexec_fn=lambda: [resource.setrlimit(*limit) for limit in LIMITS])
            try:
                status = run.wait(seconds)
            except subprocess.TimeoutExpired:
                status = "timed out"
            with contextlib.suppress(ProcessLookupError):
                os.killpg(run.pid, signal.SIGKILL)
            run.wait()
        lines = [line for line in log.read_bytes()[-4096:].decode(errors="replace").split("\n") if line.strip()]
        note = f"exit status {status}" + (f": {repr(lines[-1])[1:-1][:160]}" if lines else "")
        if status != "timed out" and (status < 0 or status in (126, 127) or 128 < status <= 192):
            status = "crashed"
        answer = claim if "{out}" in command else said
        data = answer.read_bytes() if answer.is_file() and answer.stat().st_size <= 16 << 20 else None
        is_too_large = data is not None and data[:2] == b"\x1f\x8b" and len(data) > 1 << 20
        return status, None if is_too_large else data, "" if status in (0, "timed out") else note


def answer_of(command, case, options, start=""):
    """The outcome, if there is nothing to judge, or "", the answer, and what was said."""
    status, data, note = run_command(command, points_text(case, options.hex), options.time_limit, start)
    if isinstance(status, str):
        return status, data, note
    if case["result"] == "invalid":
        return "properly refused" if status else "accepted", data, ""
    return "refused" if status else "", data, note


def judge_bytes(case, data, options):
    truth = Truth(case)
    try:
        claim = read_claim(data, len(truth.rows))
    except Unreadable as error:
        return {**BLANK, "outcome": "unreadable", "message": str(error)}
    judge = Judge(truth, claim, options.tolerance, options.highest_level)
    verdict = judge.run()
    return {**BLANK, "outcome": verdict, "findings": judge.findings, "judged": judge.judged,
            "undecided": judge.undecided, "profile": profile_of(claim, options.highest_level)}


BLANK = {"message": "", "findings": [], "judged": set(), "undecided": False, "profile": None, "orbits": []}


def judge_orbits(case, result, options):
    """Adds to the result what the orbits of the case make of it. The first negative outcome stays."""
    for true in case["expected"].get("orbits", []):
        start = ",".join(true["start"])
        outcome, data, message = answer_of(options.orbits_against, case, options, start)
        if not outcome:
            try:
                outcome = Flow(Truth(case)).verdict(read_orbit(data), read_orbit(json.dumps(true).encode()))
                result["orbits"] = [*result["orbits"], {"start": start, "outcome": outcome}]
                message = "" if outcome == CONFORMS else f"another orbit from {start}"
            except Unreadable as error:
                outcome, message = "unreadable", str(error)
        if outcome in NEGATIVE and result["outcome"] not in NEGATIVE or \
                outcome == PERTURBED and result["outcome"] in (CONFORMS, DETERMINED):
            result["outcome"], result["message"] = outcome, message
        if outcome not in (*GOOD, FAILS):
            return
    if result["profile"] and result["orbits"]:
        result["profile"]["parts"]["orbits"] = True


def judge_case(case, options):
    is_start = case.get("refused") == "start"
    command, start = (options.orbits_against, ",".join(case["start"])) if is_start else (options.against, "")
    outcome, data, note = answer_of(command, case, options, start) if command else ("skipped", None, "")
    result = {**BLANK, "outcome": outcome, "message": note} if outcome else judge_bytes(case, data, options)
    if options.orbits_against and case["result"] != "invalid":
        judge_orbits(case, result, options)
    return result


# ---- Reports


def print_negative(case, outcome):
    print(": ".join(filter(None, (f"{case['id']} ({case['comment']})", outcome["outcome"], outcome["message"]))))
    for one in [one for one in outcome["findings"] if not one["permitted"]][:3]:
        place = f"line {one['line']}" if one["line"] else f"the contact set {one['contact'] or 'of no point'}"
        print(f"  level {one['level']}: {one['reason']} [{one['clause']}]: {place}")


def print_report(cases, flags, outcomes, options):
    negative = [case for case in cases if outcomes[case["id"]]["outcome"] in NEGATIVE]
    for case in negative[:options.most]:
        print_negative(case, outcomes[case["id"]])
    if negative:
        print(f"and {len(negative) - options.most} more\n" if len(negative) > options.most else "")
    names = [f"flag {flag}" for flag in flags] + list(dict.fromkeys(f"group {case['group']}" for case in cases))
    for name in names:
        some = [outcomes[case["id"]]["outcome"] for case in cases
                if name in (f"group {case['group']}", *(f"flag {flag}" for flag in case["flags"]))]
        told = [f"{some.count(one)} {one}" for one in [*GOOD, "properly refused", *NEGATIVE] if one in some]
        if told:
            print(f"  {name + ':':30} {', '.join(told)}")
    counts = Counter(outcome["outcome"] for outcome in outcomes.values())
    levels = Counter(level for outcome in outcomes.values() for level in outcome["judged"])
    print("\njudged: " + ", ".join(f"{levels[k]} claims on level {k}" for k in range(1, options.highest_level + 1)))
    for number_of, what in [(sum(len(one["orbits"]) for one in outcomes.values()), "judged: {} orbits"),
                            (counts["skipped"], "skipped: {} cases"),
                            (sum(one["undecided"] for one in outcomes.values()), "not decided: {} cases")]:
        if number_of:
            print(what.format(number_of))
    good = counts[CONFORMS] + counts["properly refused"]
    print(f"\n{len(cases) - counts['skipped']} cases: {good} conform, {counts[DETERMINED]} where determined, "
          f"{counts[PERTURBED]} perturbed, {len(negative)} negative")
    if said := statement_of_all(outcomes, options, options.tolerance):
        print(said)
    elif statement_of_all(outcomes, options, LARGEST_STATED):
        print(f"no statement: the tolerance {options.tolerance!r} is above {LARGEST_STATED!r} (FC-CLAIM-23)")


def statement_of_all(outcomes, options, tolerance):
    """The statement of FC-CLAIM-22, with the number of vectors that it is about."""
    asked = [one for one in outcomes.values() if one["outcome"] != "skipped"]
    verdicts = [FAILS if one["outcome"] in NEGATIVE else one["outcome"] for one in asked]
    worst = max(verdicts, key=["properly refused", *GOOD, FAILS].index, default=CONFORMS)
    said = statement(CONFORMS if worst == "properly refused" else worst,
                     [one["profile"] for one in asked if one["profile"]], tolerance)
    number_of = f"{len(asked):,}" + (f" of {options.total:,}" if len(asked) < options.total else "")
    return said and f"{said} ({number_of} vectors)"


def read_vectors(options, parser):
    flags = [one["flag"] for one in json.loads(Path(options.vectors, "flags.json").read_text())["flags"]]
    groups = [json.loads(path.read_text()) for path in sorted(Path(options.vectors).glob("*.json"))]
    cases = [{**case, "group": group["group"]} for group in groups if "group" in group for case in group["cases"]]
    options.total = len(cases)
    chosen = [case for case in cases if (not options.group or case["group"] in options.group)
              and (not options.case or case["id"] in options.case)
              and (not options.flag or set(options.flag) & set(case["flags"]))]
    if not chosen:
        names = ", ".join(sorted({case["group"] for case in cases}))
        parser.error(f"no such case; the groups are {names}, and the flags {', '.join(flags)}")
    if options.claim and (len(chosen) > 1 or chosen[0]["result"] == "invalid"):
        parser.error("--claim needs one --case that is not invalid")
    return chosen, flags


def parser_of_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--against", help="the command: {in} is a file of points, {out} that of the claim; it runs in "
                        "a folder of its own, so give whole paths")
    parser.add_argument("--orbits-against", help="a command for orbits: {start} is where one starts, X,Y,Z")
    parser.add_argument("--claim", help="a claim about the points of one --case, instead of a command")
    parser.add_argument("--vectors", default=str(HERE / "vectors"), help="folder of the vectors")
    for name in ("--group", "--flag", "--case"):
        parser.add_argument(name, action="append", default=[], help="only such cases; may be given several times")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="of decimals (FC-CLAIM-23)")
    parser.add_argument("--highest-level", type=int, choices=[1, 2, 3, 4], default=4,
                        help="judge levels 1 to this one")
    parser.add_argument("--time-limit", type=float, default=10, help="seconds after which a run is killed")
    parser.add_argument("--most", type=int, default=10, help="show so many negative cases")
    parser.add_argument("--hex", action="store_true", help="points as hexadecimal floats, not as shortest decimals")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    return parser


def outcomes_of(cases, options, parser):
    if options.claim:
        return {cases[0]["id"]: judge_bytes(cases[0], Path(options.claim).read_bytes(), options)}
    for command in filter(None, (options.against, options.orbits_against)):
        if run_command(command, "0 0 0\n2 0 0\n", options.time_limit)[0] == "crashed":
            parser.error(f"the command cannot be run: {command}")
    return {case["id"]: judge_case(case, options) for case in cases}


def main():
    parser = parser_of_options()
    options = parser.parse_args()
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # a reader that has seen enough may close the pipe
    if not 0 <= options.tolerance <= 1e-3 or bool(options.against) == bool(options.claim):
        parser.error("needs --against or --claim, and a tolerance from 0 to 0.001")
    if options.orbits_against and (options.claim or "{start}" not in options.orbits_against):
        parser.error("--orbits-against needs {start} in its command, and --against beside it")
    try:
        cases, flags = read_vectors(options, parser)
        outcomes = outcomes_of(cases, options, parser)
    except OSError as error:
        parser.error(str(error))
    if options.json:
        keep = ("outcome", "message", "findings", "undecided", "orbits")
        told = [{"id": key, **{name: one[name] for name in keep}, "judged": sorted(one["judged"])}
                for key, one in outcomes.items()]
        print(json.dumps({"format": "flowcert-judge", "format_version": 1, "cases": told,
                          "statement": statement_of_all(outcomes, options, options.tolerance),
                          "own_seconds": resource.getrusage(resource.RUSAGE_SELF).ru_utime}))
    else:
        print_report(cases, flags, outcomes, options)
    return 1 if any(one["outcome"] in NEGATIVE for one in outcomes.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
