#!/usr/bin/env python3
"""Orbits and stationary points of the distance function of a point set, exactly, from the specification's text alone.

    orbits_from_spec.py orbit POINTS.xyz START OUT.json     START is x,y,z (formats/orbit.md)
    orbits_from_spec.py u2 POINTS.xyz OUT.jsonl             a claim (formats/claims.md, stationary_points.md)
"""
import json
import re
import sys
from fractions import Fraction
from itertools import combinations
from math import inf, isinf, lcm

DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
HEX = re.compile(r"[+-]?0[xX](?=\.?[0-9a-fA-F])([0-9a-fA-F]*)\.?([0-9a-fA-F]*)([pP][+-]?\d+)?", re.ASCII)


def number(word, fractions=False):
    """The exact value of a decimal or hexadecimal float (FC-IN-02), or of p/q where these are allowed."""
    if fractions and re.fullmatch(r"[+-]?\d+/\d+", word, re.ASCII) and int(word.split("/")[1]):
        return Fraction(word)
    if match := HEX.fullmatch(word):
        value, digits = float.fromhex(word), int(match[1] + match[2], 16)
        power = int((match[3] or "p0")[1:]) - 4 * len(match[2])
        if abs(Fraction(value)) != (digits * Fraction(2) ** power if value else digits):
            raise ValueError("a hexadecimal float that is no double")
    elif DECIMAL.fullmatch(word):
        value = float(word)
    else:
        raise ValueError(f"{word[:40]!r} is no number")
    if isinf(value):
        raise ValueError("a number overflows")
    return Fraction(value)  # This makes -0.0 the same as 0.0.


def words_of(line):
    return re.split(r"[ \t]*,[ \t]*|[ \t]+", line.strip(" \t\r"))


def read_points(path):
    """The rows of an XYZ file (formats/points.md)."""
    with open(path, "rb") as file:
        data = file.read()
    if not data.strip():
        raise ValueError("nothing to read")
    rows = [words_of(line.split("#")[0]) for line in data.decode("latin-1").split("\n")]
    rows = [row for row in rows if row != [""]]
    rows = rows[1:] if rows and [word.lower() for word in rows[0][:3]] == ["x", "y", "z"] else rows
    if any(len(row) < 3 for row in rows):
        raise ValueError("a row with too few numbers")
    return [tuple(map(number, row[:3])) for row in rows]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def weights(points):
    """Barycentric coordinates of the centre of the smallest sphere through the points; None if they are dependent."""
    edges = [sub(p, points[0]) for p in points[1:]]
    rows = [[Fraction(dot(e, f)) for f in edges] + [Fraction(dot(e, e), 2)] for e in edges]
    for i in range(len(rows)):
        if rows[i][i] == 0:  # The matrix is positive semidefinite, so that no other pivot has to be looked for.
            return None
        rows[i] = [value / rows[i][i] for value in rows[i]]
        rows = [rows[i] if row is rows[i] else [b - row[i] * a for a, b in zip(rows[i], row)] for row in rows]
    return [1 - sum(row[-1] for row in rows)] + [row[-1] for row in rows]


def dimension(points):
    """The dimension of the affine hull."""
    basis = []
    for p in points:
        basis += [p] if len(basis) < 4 and weights(basis + [p]) else []
    return len(basis) - 1


def driver(points):
    """The centre of the smallest ball that encloses the points (FC-DIST-02)."""
    basis, centre, radius = points[:1], tuple(map(Fraction, points[0])), 0
    while True:
        far = max(points, key=lambda p: dot(sub(p, centre), sub(p, centre)))
        if dot(sub(far, centre), sub(far, centre)) <= radius:
            return centre
        # The ball of a few points is the largest one among those of their parts that have the centre in their hull.
        old = basis
        for part in (list(part) + [far] for size in (1, 2, 3) for part in combinations(old, size)):
            shares = weights(part)
            if shares and min(shares) > 0:
                middle = tuple(sum(share * p[k] for share, p in zip(shares, part)) for k in range(3))
                square = dot(sub(middle, far), sub(middle, far))
                if square > radius:
                    radius, centre, basis = square, middle, part


class Flow:
    """The points, scaled by a power of two to integers; all is done by the definitions, with scans over them."""

    def __init__(self, rows):
        self.scale = lcm(*(value.denominator for row in rows for value in row))
        first = {}
        for i, row in enumerate(rows):
            first.setdefault(tuple(int(value * self.scale) for value in row), i)
        self.points, self.name, self.limits = list(first), first, {}

    def contact(self, x):
        """The samples nearest to x, by class names (FC-DIST-01, FC-IN-03)."""
        low = lcm(*(value.denominator for value in x))
        top = [int(value * low) for value in x]
        values = [low * dot(p, p) - 2 * dot(top, p) for p in self.points]
        least = min(values)
        return [p for p, value in zip(self.points, values) if value == least]

    def ids(self, samples):
        return samples and [self.name[p] for p in samples]

    def text(self, x):
        return x and [str(value / self.scale) for value in x]

    def advance(self, x, u, crossed):
        """The first point after x in the direction u whose contact set is not the crossed one, or None (FC-FLOW-01)."""
        far = [(dot(u, q), dot(q, q) - 2 * dot(x, q)) for q in crossed[:1] + self.points]
        time = min((Fraction(d - far[0][1]) / (2 * (v - far[0][0])) for v, d in far if v > far[0][0]), default=None)
        return None if time is None else tuple(a + time * b for a, b in zip(x, u))

    def orbit(self, x):
        """The flow segments from x on, and where they end, or None for infinity (FC-FLOW-01 to 05)."""
        segments, near = [], self.contact(x)
        while x and (centre := driver(near)) != x:
            u = sub(x, centre)
            most = max(dot(u, p) for p in near)
            crossed = [p for p in near if dot(u, p) == most]
            x = self.advance(x, u, crossed)
            sets = [near, crossed, self.contact(x) if x else None]
            segments.append({"type": "-".join("CFEV"[dimension(s)] if s else "inf" for s in sets),
                             "driver": self.text(centre), "end": self.text(x), "start_contact": self.ids(near),
                             "crossed_contact": self.ids(crossed), "end_contact": self.ids(sets[2])})
            near = sets[2]
        return segments, x

    def orbit_object(self, start):
        """What formats/orbit.md asks for."""
        segments, last = self.orbit(tuple(value * self.scale for value in start))
        limit = self.record(last) if last else {"kind": "infinity"}
        return {"format": "flowcert-orbit", "format_version": 1, "start": list(map(str, start)), "segments": segments,
                "limit": {"kind": limit["kind"], "index": limit.get("index"), "position": limit.get("center"),
                          "contact": limit.get("contact"), "squared_distance": limit.get("squared_distance")}}

    def record(self, x):
        """What FC-CRIT-01 to 03 say of a position; None if it is not stationary."""
        if driver(near := self.contact(x)) != x:
            return None
        size, arms = dimension(near), [sub(p, x) for p in near]
        axes = arms + ([cross(sub(near[1], near[0]), sub(near[2], near[0]))] if size == 2 else [])
        # The face that has x in its relative interior is what all supporting planes through x have in common.
        planes = [[dot(cross(a, b), arm) for arm in arms] for a, b in combinations(axes, 2)]
        planes = [signs for signs in planes if min(signs) * max(signs) >= 0 and any(signs)]
        inner = dimension([p for p, *signs in zip(near, *planes) if not any(signs)])
        return {"index": size if inner == size else [inner, size], "kind": "critical" if inner == size else "regular",
                "contact": self.ids(near), "center": self.text(x),
                "squared_distance": str(dot(sub(x, near[0]), sub(x, near[0])) / self.scale ** 2)}

    def side(self, x, u, near):
        """Where the orbit ends that leaves an index-2 point in the direction u, as a contact set (FC-FLOW-07)."""
        end = self.advance(x, u, near)
        if end not in self.limits:
            last = end and self.orbit(end)[1]
            self.limits[end] = self.ids(last and self.contact(last))
        return self.limits[end]

    def candidates(self):
        """Positions that all stationary points are among: samples, middles of pairs, and of each triple the centre of
        its circle and the ends of those points on its axis to which no sample is nearer (FC-VOR-03)."""
        found = {tuple(map(Fraction, p)) for p in self.points}
        for a, b in combinations(self.points, 2):
            if all(dot(sub(q, a), sub(q, b)) >= 0 for q in self.points):
                found.add(tuple(Fraction(s + t, 2) for s, t in zip(a, b)))
        for a, b, c in combinations(self.points, 3):
            b, c, low, high = sub(b, a), sub(c, a), -inf, inf
            n = cross(b, c)
            v, area = cross([dot(b, b) * s - dot(c, c) * t for s, t in zip(c, b)], n), dot(n, n)
            # The axis is a + (v + s n) / (2 area), and q is no nearer than a iff s <n,q-a> <= bound.
            for q in (sub(q, a) for q in self.points):
                bound, slope = area * dot(q, q) - dot(v, q), dot(n, q)
                if slope:
                    low = max(low, Fraction(bound, slope)) if slope < 0 else low
                    high = min(high, Fraction(bound, slope)) if slope > 0 else high
                if low > high or slope == 0 > bound or area == 0:
                    break
            else:
                for s in {low, high, Fraction(0)} - {-inf, inf}:
                    if low <= s <= high:
                        found.add(tuple(k + (i + s * j) / (2 * area) for k, i, j in zip(a, v, n)))
        return found

    def claim(self, rows):
        """A header, and all stationary points in the order of FC-OUT-02."""
        kinds, found = [0, 1, 2, 3, [1, 2], [1, 3], [2, 3]], [(x, self.record(x)) for x in self.candidates()]
        for x, record in found:
            if record and record["index"] == 1:
                record["samples"] = record["contact"]
            elif record and record["index"] == 2:
                a, b, c, *_ = near = self.contact(x)
                up, down = cross(sub(b, a), sub(c, a)), cross(sub(c, a), sub(b, a))
                record["limits"] = [self.side(x, down, near), self.side(x, up, near)]
        records = [record for x, record in found if record]
        records.sort(key=lambda record: (kinds.index(record["index"]), record["contact"]))
        counts = [sum(record["index"] == kind for record in records) for kind in kinds]
        return [{"format": "flowcert-stationary-points", "format_version": 1, "points": rows,
                 "merged_duplicates": rows - len(self.points), "critical": counts[:4],
                 "regular_stationary": dict(zip(("1-2", "1-3", "2-3"), counts[4:]))}] + records


def main(words):
    sys.set_int_max_str_digits(0)
    try:
        if [len(words), *words[:1]] not in ([4, "orbit"], [3, "u2"]):
            raise ValueError("usage: orbit POINTS.xyz START OUT.json, or u2 POINTS.xyz OUT.jsonl")
        rows = read_points(words[1])
        if words[0] == "orbit":
            start = [number(word, True) for word in words_of(words[2])]
            if len(start) != 3 or not rows:
                raise ValueError("a position is three numbers, and needs a point (FC-FLOW-10)")
        out = open(words[-1], "w", encoding="utf-8")
    except (ValueError, ArithmeticError, OSError) as error:
        sys.exit(print("flowcert:", " ".join(str(error).split()), file=sys.stderr) or 2)
    flow = Flow(rows)
    with out:
        lines = [flow.orbit_object(start)] if words[0] == "orbit" else flow.claim(len(rows))
        out.writelines(json.dumps(line) + "\n" for line in lines)


if __name__ == "__main__":
    main(sys.argv[1:])
