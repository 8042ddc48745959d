#!/usr/bin/env python3
"""stationary_points_from_spec.py POINTS CLAIM

All stationary points of a point file in the XYZ format, exactly, written from spec/ alone.

It follows the clauses FC-IN-01 to 05, FC-CRIT-01 to 06, FC-OUT-01 and 02, and takes time O(n^4).
It knows nothing of Flowcert's code, and shows that the spec is enough. spec/judge.py judges it.
Exit status: 0, or 2 for what is no point file.
"""
import itertools
import json
import math
import re
import sys
from fractions import Fraction

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
HEXADECIMAL = re.compile(r"([+-]?)0[xX]([0-9a-fA-F]*)\.?([0-9a-fA-F]*)([pP][+-]?\d+)?")


def coordinate(word):
    """FC-IN-01, FC-IN-02. What is no number, or beyond the doubles, raises ValueError or OverflowError."""
    parts = HEXADECIMAL.fullmatch(word)
    if parts and parts[2] + parts[3]:
        value = float.fromhex(word)
        digits = int(parts[2] + parts[3], 16)
        power = int((parts[4] or "p0")[1:]) - 4 * len(parts[3])
        exact = digits and Fraction(2) ** max(-9999, min(power, 9999)) * digits
        if abs(Fraction(value)) != exact:
            raise ValueError(f"no double: {word}")
    elif NUMBER.fullmatch(word):
        value = float(word)
    else:
        raise ValueError(f"no number: {word}")
    return Fraction(value)  # an infinity raises OverflowError


def read_points(text):
    """FC-IN-05."""
    if not text.strip():
        raise ValueError("an empty file")
    points, may_be_names = [], True
    for line in re.split("\r\n|\r|\n", text):
        line = line.split("#")[0].strip()
        words = re.split(r"[ \t]*,[ \t]*|[ \t]+", line)
        if line and not (may_be_names and [word.lower() for word in words[:3]] == ["x", "y", "z"]):
            if len(words) < 3:
                raise ValueError("too few numbers")
            points.append(tuple(coordinate(word) for word in words[:3]))
        may_be_names = may_be_names and not line
    return points


# ---- Vectors


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dimension(points):
    """Of the affine hull."""
    basis = []
    for v in (minus(p, points[0]) for p in points[1:]):
        is_new = (any(v), len(basis) == 1 and any(cross(basis[0], v)), len(basis) == 2 and dot(cross(*basis), v))
        if len(basis) < 3 and is_new[len(basis)]:
            basis.append(v)
    return len(basis)


# ---- Centres of empty balls


def centers_through(points, a, b, c):
    """Of three points on no line: the smallest sphere through them, if no point is in it, and the two through a fourth.

    The centre is a + (m + t n) / (2 n.n), and every other point bounds t from above or below, or rules out all t.
    """
    u, v = minus(b, a), minus(c, a)
    n = cross(u, v)
    nn = dot(n, n)
    if not nn:
        return
    m = tuple(dot(u, u) * x + dot(v, v) * y for x, y in zip(cross(v, n), cross(n, u)))
    low, high = None, None  # pairs (numerator, positive denominator)
    for p in points:
        w = minus(p, a)
        side, free = dot(w, n), nn * dot(w, w) - dot(w, m)
        if side > 0 and (high is None or free * high[1] < high[0] * side):
            high = free, side
        elif side < 0 and (low is None or -free * low[1] > low[0] * -side):
            low = -free, -side
        elif not side and free < 0:
            return
        if low and high and low[0] * high[1] > high[0] * low[1]:
            return
    smallest = (0, 1) if not (low and low[0] > 0) and not (high and high[0] < 0) else None
    for t in {smallest, low, high} - {None}:
        yield tuple(x + (Fraction(y) + Fraction(*t) * z) / (2 * nn) for x, y, z in zip(a, m, n))


def stationary_points(points):
    """Triples: (index of the face, dimension of the hull), contact set as places, centre, squared distance."""
    centers = {tuple(map(Fraction, p)) for p in points}
    centers |= {tuple(Fraction(x + y, 2) for x, y in zip(*pair)) for pair in itertools.combinations(points, 2)}
    for triple in itertools.combinations(points, 3):
        centers.update(centers_through(points, *triple))
    for x in centers:
        scale = math.lcm(*(y.denominator for y in x))
        scaled = tuple(int(y * scale) for y in x)
        squared = [dot(v, v) for v in (minus(tuple(scale * y for y in p), scaled) for p in points)]
        least = min(squared)
        contact = [k for k, one in enumerate(squared) if one == least]
        face = face_with_inside([points[k] for k in contact], x)
        if face:
            hull = dimension([points[k] for k in contact])
            yield (dimension(face), hull), contact, x, Fraction(least, scale**2)


def face_with_inside(contact, x):
    """The vertices of the face of the contact set's hull that has x in its relative interior (FC-CRIT-02, 03).

    They are the points of all simplices with x in their relative interior. Empty if x is not in the hull.
    """
    all_of, face = dimension(contact), set()
    v = {p: minus(p, x) for p in contact}
    for size in range(1, 5):
        for some in itertools.combinations(contact, size):
            if not face.issuperset(some) and has_zero_inside([v[p] for p in some]):
                face.update(some)
        if face and dimension(sorted(face)) == all_of:
            break
    return sorted(face)


def has_zero_inside(v):
    """Whether 0 is in the relative interior of a simplex of up to four vectors of one length."""
    if len(v) < 3:
        return not any(sum(part) for part in zip(*v))
    if len(v) == 3:
        n = cross(v[0], v[1])
        return not dot(n, v[2]) and dot(n, cross(v[1], v[2])) > 0 and dot(n, cross(v[2], v[0])) > 0
    a, b, c, d = v
    signs = [dot(cross(p, q), r) > 0 for p, q, r in ((b, c, d), (a, d, c), (a, b, d), (a, c, b))]
    flat = any(not dot(cross(p, q), r) for p, q, r in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)))
    return not flat and len(set(signs)) == 1


def main():
    try:
        rows = read_points(open(sys.argv[1], encoding="utf-8").read())
    except (ValueError, OverflowError, OSError) as error:
        print(f"{sys.argv[1]}: {error}", file=sys.stderr)
        return 2
    unit = max((x.denominator for row in rows for x in row), default=1)  # a power of 2, so that all becomes whole
    names = {}
    for row, p in enumerate(rows):
        names.setdefault(tuple(int(x * unit) for x in p), row)
    points = list(names)
    lines = []
    for index, contact, x, squared in stationary_points(points) if points else []:
        lines.append({"index": index[0] if index[0] == index[1] else list(index),
                      "contact": [names[points[k]] for k in contact],
                      "center": [str(y / unit) for y in x], "squared_distance": str(squared / unit**2)})
    lines.sort(key=lambda one: (isinstance(one["index"], list), one["index"], one["contact"]))
    head = {"format": "flowcert-stationary-points", "format_version": 1, "points": len(rows),
            "merged_duplicates": len(rows) - len(points)}
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.writelines(json.dumps(one) + "\n" for one in [head, *lines])
    return 0


if __name__ == "__main__":
    sys.exit(main())
