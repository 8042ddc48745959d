#!/usr/bin/env python3
"""Judges any program that computes critical points, by the conformance vectors, without a build.

    judge.py --against 'my-program {in} {out}'        runs it on all vectors beside this file, and prints a table
    judge.py --against '...' --orbits-against 'my-orbits {in} {start} {out}'      asks for orbits, too
    judge.py --case duplicates-0003 --claim FILE      judges one claim

It judges the levels 1 to 4 of FC-CLAIM-19 (claims.md) and orbits, exactly: with fractions, never with a double.
It says in which profile (FC-CLAIM-22) the claim or the program conforms.
It reads the exchange format, CSV and the format of Giesen and Kühne (formats/claims.md).
What they say on level 5 is not judged; of its keys, only the ids are read.
Exit status: 0 if nothing is negative, 1 if something is, 2 for what cannot be used.
"""
import argparse, gzip, hashlib, itertools, json, os, re, resource, shlex, signal, struct, subprocess, sys, tempfile
from collections import Counter
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

sys.set_int_max_str_digits(0)
VERSION = "1.1"  # of the specification
TINY = Fraction(1, 2**44)  # what rounding explains (FC-CLAIM-05)
KINDS = {(1, 2), (1, 3), (2, 3)}
CONFORMS, DETERMINED, PERTURBED, FAILS = "conforms", "conforms where determined", "perturbed", "fails"
GOOD = [CONFORMS, DETERMINED, PERTURBED]
COLUMNS = ["conforms", "determined", "perturbed", "fails", "refused", "crashed", "timed out", "unreadable"]
COLUMN_OF = {"properly refused": "conforms", DETERMINED: "determined", "accepted": "fails"}


class Unreadable(Exception):
    """A claim that means nothing. The message says where and why."""


def require(condition, message):
    if not condition:
        raise Unreadable(message)


# ---- Numbers (formats/claims.md). A number is a pair: its value, and whether it is claimed exactly.


class Literal(str):
    """A number of JSON, as it stands there."""


def hexadecimal(text):
    parts = re.fullmatch(r"([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?\d+))?", text)
    require(parts and (parts[2] or parts[3]), f"not a number: {text}")
    digits, after = parts[2] + (parts[3] or ""), parts[3] or ""
    power = int(parts[4] or 0) - 4 * len(after)
    mantissa = int(digits, 16)
    require(abs(power) < 9999 or not mantissa, f"not a double: {text}")
    value = Fraction(mantissa) * Fraction(2) ** power if mantissa else Fraction(0)
    require(nearest_double(value) is not None and Fraction(nearest_double(value)) == value, f"not a double: {text}")
    return -value if parts[1] == "-" else value


def number(text, plain_is_exact=False):
    if "/" in text:
        parts = re.fullmatch(r"([+-]?\d+)/(\d+)", text)
        require(parts and int(parts[2]) and len(text) <= 1000000, f"not a fraction: {text[:40]}")
        return Fraction(int(parts[1]), int(parts[2])), True
    if "x" in text or "X" in text:
        return hexadecimal(text), True
    parts = re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)(?:[eE]([+-]?\d+))?", text)
    require(parts, f"not a number: {text[:40]}")
    exact = plain_is_exact and text.lstrip("+-").isdigit()
    require(len(text) <= (1000000 if exact else 2000) and abs(int(parts[2] or 0)) <= 700, f"too long: {text[:40]}")
    return Fraction(text), exact


def not_negative(value):
    require(value[0] >= 0, "a negative distance")
    return value


def nearest_double(value):
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return None


def rounds_alike(a, b):
    return nearest_double(a) is not None and nearest_double(a) == nearest_double(b)


def roots_differ_by(a, b, squared_length):
    """Whether the roots of a and b differ by no more than a length: d^2 + r^2 - t^2 <= 2 d r."""
    left = a + b - squared_length
    return left <= 0 or left * left <= 4 * a * b


# ---- Claims, read. `hull` is the second part of a kind, and None for a critical point. A target None is infinity.


def blank_point(line):
    return SimpleNamespace(line=line, index=0, hull=None, contact=[], center=None, squared=None, distance=None,
                           doubles=None, squared_double="none", targets=None, by_side=False, samples=None,
                           boundary=None, lists=[])


def whole(value):
    require(isinstance(value, Literal) and re.fullmatch(r"\d+", value), f"not a whole number: {value}")
    return int(value)


def ids(value):
    require(isinstance(value, list), f"not an array of ids: {value}")
    found = [whole(one) for one in value]
    require(all(one <= 2147483646 for one in found), "an id beyond 2147483646")
    return found


def index_of(value):
    require(isinstance(value, str) and value in ("0", "1", "2", "3"), f"not an index, 0 to 3: {value}")
    return int(value)


def json_number(value):
    require(isinstance(value, str), f"not a number: {value}")
    return number(value, plain_is_exact=not isinstance(value, Literal))


def three(value, read):
    require(isinstance(value, list) and len(value) == 3, f"not three coordinates: {value}")
    return [read(one) for one in value]


def object_of(pairs):
    require(len(dict(pairs)) == len(pairs), "a key twice")
    return dict(pairs)


def parse_float(text):
    require(abs(float(text)) < float("inf"), f"out of range of a double: {text}")
    return Literal(text)


def parse(line):
    try:
        value = json.loads(line, object_pairs_hook=object_of, parse_int=parse_float, parse_float=parse_float,
                           parse_constant=lambda text: require(False, "not JSON"))
    except (json.JSONDecodeError, RecursionError) as error:
        raise Unreadable(f"not JSON: {error}") from error
    require(isinstance(value, dict), "not an object")
    return value


def lists_in(value, key=""):
    """The lists of ids in what belongs to level 5."""
    if key == "shares" or key == "shares_double":
        return [ids([one[0] for one in value])]
    if key == "walk":
        return [[one] for one in ids(value or [])]
    if key in ("samples", "polygon", "front_contact", "back_contact", "limit", "to") and isinstance(value, list):
        if all(isinstance(one, Literal) for one in value):
            return [ids(value)]
    if key == "arcs":
        return [ids(one) for one in value if one is not None]
    if isinstance(value, dict):
        return [found for name, one in value.items() for found in lists_in(one, name)]
    return [found for one in value for found in lists_in(one, "")] if isinstance(value, list) else []


def exchange_record(record, line):
    point = blank_point(line)
    require("index" in record, "no key 'index'")
    if isinstance(record["index"], list):
        require(len(record["index"]) == 2, "a kind has two parts")
        point.index, point.hull = map(index_of, record["index"])
        require((point.index, point.hull) in KINDS, "only the kinds 1-2, 1-3 and 2-3 exist")
    else:
        point.index = index_of(record["index"])
    is_regular = point.hull is not None
    kind = "regular" if is_regular else "critical"
    require(record.get("kind", kind) == kind, f"the index says {kind}")
    if "contact" in record:
        point.contact = ids(record["contact"])
        require(point.contact, "an empty contact set")
    near = record.get("center_double")
    doubles = None if near is None else three(near, lambda one: None if one is None else json_number(one))
    if "center" in record:
        point.center, point.doubles = three(record["center"], json_number), doubles
    elif doubles and None not in doubles:
        point.center = doubles
    near = record.get("squared_distance_double")
    near = None if near is None else not_negative(json_number(near))
    point.squared = not_negative(json_number(record["squared_distance"])) if "squared_distance" in record else near
    if "squared_distance" in record and "squared_distance_double" in record:
        point.squared_double = near
    require(point.contact or point.center, "neither 'contact' nor 'center'")
    for keys, indices, with_regular in [(["samples"], [1], False), (["limits", "u2"], [2], False),
                                        (["stable", "surface"], [2], True), (["skeleton"], [2, 3], True),
                                        (["lambda", "connections"], [1, 2], True),
                                        (["shares", "shares_double"], [2, 3], True), (["u1"], [1], True)]:
        for key in keys:
            may = point.index in indices if not is_regular else with_regular and (key != "u1" or point.index == 1)
            require(key not in record or may, f"a key that such a point has not: '{key}'")
            if key in record and key not in ("samples", "limits", "u2", "surface", "stable"):
                point.lists += lists_in(record[key], key)
    if "samples" in record:
        point.samples = ids(record["samples"])
    if "limits" in record:
        require(isinstance(record["limits"], list) and len(record["limits"]) == 2, "there are two limits")
        point.targets, point.by_side = [None if one is None else ids(one) for one in record["limits"]], True
    stable = record.get("stable", {})
    if "boundary" in stable:
        require(not is_regular, "a boundary, which only critical points have")
        point.boundary = [ids(one) for one in stable["boundary"]]
    point.lists += lists_in(stable.get("walk", []), "walk")
    return point


def read_exchange(text):
    lines = [(k, line) for k, line in enumerate(re.split("\r\n|\r|\n", text), 1) if line.strip(" \t")]
    head = parse(lines[0][1])
    is_known = head.get("format") == "flowcert-stationary-points" and head.get("format_version") == "1"
    require(is_known, "an unknown format")
    claim = SimpleNamespace(points=[], infinity=[], indices={0, 1, 2, 3}, head={}, has_indices=False)
    for key in ("points", "merged_duplicates"):
        if key in head:
            claim.head[key] = whole(head[key])
    if "input_sha256" in head:
        require(re.fullmatch("[0-9a-f]{64}", head["input_sha256"]), "not 64 lower case hexadecimal digits")
        claim.head["input_sha256"] = head["input_sha256"]
    if "classes" in head:
        claim.head["classes"] = [ids(one) for one in head["classes"]]
    if "critical" in head:
        claim.head["critical"] = [whole(one) for one in head["critical"]]
        require(len(claim.head["critical"]) == 4, "there are four counts")
    if "regular_stationary" in head:
        require(all(kind in head["regular_stationary"] for kind in ("1-2", "1-3", "2-3")), "not three counts")
        claim.head["regular"] = [whole(head["regular_stationary"][kind]) for kind in ("1-2", "1-3", "2-3")]
    if "indices" in head:
        claim.indices = {index_of(one) for one in head["indices"]}
        require(len(claim.indices) == len(head["indices"]), "an index twice")
    seen_infinity = False
    for line, text_of_line in lines[1:]:
        record = parse(text_of_line)
        if record.get("kind") == "infinity":
            require(not seen_infinity and "skeleton" in record, "a second line of infinity, or one without a skeleton")
            seen_infinity = True
            claim.infinity = lists_in(record["skeleton"])
        else:
            claim.points.append(exchange_record(record, line))
    return claim


def read_csv(lines):
    points = []
    for k, line in enumerate(lines, 1):
        line = line.split("#")[0].strip(" \t")
        fields = [one.strip(" \t") for one in re.split(r"[ \t]*,[ \t]*|[ \t]+", line)] if line else []
        if not fields or (not points and fields[0] == "index"):
            continue
        while len(fields) > 4 and not fields[-1]:
            fields.pop()
        point = blank_point(k)
        point.index = index_of(fields[0])
        require(len(fields) >= 4, "too few numbers after the index")
        point.center = [number(one) for one in fields[1:4]] if any(fields[1:4]) else None
        point.squared = not_negative(number(fields[4])) if len(fields) > 4 and fields[4] else None
        point.contact = ids([Literal(one) for one in fields[5:]])
        require(point.center or point.contact, "neither a position nor contact ids")
        points.append(point)
    return points


def read_bars(lines):
    points, infinities = [], 0
    for k, line in enumerate(lines, 1):
        parts = [one.split() for one in line.split("|")]
        if parts[0][:1] == ["inf"]:
            require(parts == [["inf", "3"]] and not infinities, "not one maximum at infinity in dimension 3")
            infinities = 1
        elif line.strip():
            parts = parts[:-1] if not parts[-1] else parts
            point = blank_point(k)
            point.contact = ids([Literal(one) for one in parts[0]])
            require(1 <= len(point.contact) <= 4 and len(parts) > 1 and len(parts[1]) == 1, "no ids, or no distance")
            point.index = len(point.contact) - 1
            point.distance = not_negative(number(parts[1][0]))
            point.targets = [None if one == ["inf"] else ids([Literal(word) for word in one]) for one in parts[2:]]
            require(all(one is None or 1 <= len(one) <= 4 for one in point.targets), "a successor of no ids")
            points.append(point)
    return points


def read_claim(data, rows):
    """The claim in some bytes, about so many rows."""
    if data[:2] == b"\x1f\x8b":
        try:
            data = gzip.decompress(data)
        except (OSError, EOFError) as error:
            raise Unreadable(f"damaged: {error}") from error
    require(data, "an empty file")
    text = data.decode("utf-8", "replace")
    lines = re.split("\r\n|\r|\n", text)
    first = next((one for one in (line.split("#")[0].strip() for line in lines) if one), "")
    if text.lstrip(" \t\r\n")[:1] == "{":
        try:
            claim = read_exchange(text)
        except (AttributeError, TypeError, KeyError, IndexError) as error:
            raise Unreadable(f"not as the format says: {error}") from error
    else:
        require(first[:1] != "<", "VTP is not read here")
        points = read_bars(lines) if "|" in first or first.split()[:1] == ["inf"] else read_csv(lines)
        claim = SimpleNamespace(points=points, infinity=[], indices={0, 1, 2, 3}, head={})
    for point in [*claim.points, None]:
        lists = claim.infinity if point is None else all_lists(point)
        require(all(one < rows for some in lists for one in some), "there is no such point")
    return claim


def all_lists(point):
    more = [one for one in point.targets or [] if one is not None] + (point.boundary or []) + point.lists
    return [point.contact, point.samples or []] + more


# ---- Geometry


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def det(a, b, c):
    return dot(cross(a, b), c)


def sphere_through(points):
    """The smallest sphere through the first of the points that span their affine hull: centre, squared radius."""
    p, basis = points[0], []
    for v in (minus(q, points[0]) for q in points[1:]):
        if not basis or (len(basis) == 1 and any(cross(basis[0], v))) or (len(basis) == 2 and det(*basis, v)):
            basis.append(v)
    offset = (Fraction(0),) * 3
    if len(basis) == 1:
        offset = tuple(x / 2 for x in basis[0])
    elif len(basis) > 1:
        a, b = basis[:2]
        c = basis[2] if len(basis) == 3 else cross(a, b)
        squares = [dot(a, a), dot(b, b), dot(c, c) if len(basis) == 3 else 0]
        terms = [[s * x for x in n] for s, n in zip(squares, (cross(b, c), cross(c, a), cross(a, b)))]
        offset = tuple(sum(term[k] for term in terms) / (2 * det(a, b, c)) for k in range(3))
    return tuple(x + y for x, y in zip(p, offset)), dot(offset, offset)


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
    for a, b, c, d in itertools.combinations(v, 4):
        signs = {sign(det(b, c, d)), sign(det(a, d, c)), sign(det(a, b, d)), sign(det(a, c, b))}
        if len(signs) == 1 and 0 not in signs:
            return True
    return False


def sign(x):
    return (x > 0) - (x < 0)


# ---- The truth: a case of the vectors


class Truth:
    def __init__(self, case):
        self.rows = [tuple(float.fromhex(word) for word in row) for row in case["points"]]
        self.points = [tuple(Fraction(x) for x in row) for row in self.rows]
        first, classes = {}, {}
        self.name = [first.setdefault(p, k) for k, p in enumerate(self.points)]
        for row, name in enumerate(self.name):
            classes.setdefault(name, []).append(row)
        self.classes = [rows for rows in classes.values() if len(rows) > 1]
        self.merged = len(self.rows) - len(classes)
        self.records, self.at = [], {}
        for k, value in enumerate(case["expected"]["stationary"]):
            index = value["index"] if isinstance(value["index"], list) else [value["index"]] * 2
            told = value.get("incidences", {})
            self.records.append(SimpleNamespace(
                k=k, index=index[0], hull=index[1], critical=index[0] == index[1], contact=tuple(value["contact"]),
                center=tuple(map(Fraction, value["center"])), squared=Fraction(value["squared_distance"]), told=told))
            self.at[tuple(value["contact"])] = k
        self.with_name = {}
        for record in self.records:
            for name in record.contact:
                self.with_name.setdefault(name, []).append(record)
            coordinates = max((abs(x) for x in record.center), default=0)
            record.allowed = record.squared or coordinates**2  # times the squared tolerance
            record.rounding = TINY**2 * max(record.squared, coordinates**2)

    def limits(self, k):
        return [None if one is None else self.at[tuple(one)] for one in self.records[k].told["limits"]]

    def has_tie(self, k):
        return self.records[k].told["boundary"] is None

    def digest(self):
        return hashlib.sha256(b"".join(struct.pack("<3d", *(x + 0.0 for x in row)) for row in self.rows)).hexdigest()


# ---- The judge. `fit` says how a claimed contact set fits its record: "whole", "part", "other", or "position".


class Judge:
    def __init__(self, truth, claim, tolerance, highest=4):
        self.truth, self.claim, self.tolerance, self.highest = truth, claim, tolerance, highest
        self.findings, self.undecided, self.judged = [], False, {1}
        self.perturbed = {}  # record: the claims that a perturbation makes of it
        self.memo = {}

    def find(self, level, reason, clause, point=None, permitted=False, contact=()):
        line, contact = (point.line, point.contact) if point else (None, contact)
        self.findings.append({"level": level, "reason": reason, "permitted": permitted, "clause": clause, "line": line,
                              "contact": list(contact)})

    def vary(self, level, reason, clause, point):
        self.find(level, reason, clause, point, permitted=True)

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
        verdict = CONFORMS
        for one in self.findings:
            permitted = PERTURBED if one["reason"] == "symbolic-perturbation" else DETERMINED
            verdict = max(verdict, permitted if one["permitted"] else FAILS, key=[*GOOD, FAILS].index)
        return verdict

    # ---- Level 1 (FC-CLAIM-01, 12)

    def check_form(self):
        truth, head = self.truth, self.claim.head
        for key, value, reason, clause in [("points", len(truth.rows), "wrong-counts", "FC-IN-03"),
                                           ("merged_duplicates", truth.merged, "wrong-counts", "FC-IN-03"),
                                           ("classes", truth.classes, "malformed", "FC-IN-03"),
                                           ("input_sha256", truth.digest(), "malformed", "FC-CLAIM-01")]:
            if head.get(key, value) != value:
                self.find(1, reason, clause)
        listed = Counter((point.index, point.hull) for point in self.claim.points)
        counts = [listed[k, None] for k in range(4)]
        self.claimed_counts = counts
        critical = [n if k in self.claim.indices else counts[k] for k, n in enumerate(head.get("critical", counts))]
        if critical != counts:
            self.find(1, "wrong-counts", "FC-CLAIM-01")
        if head.get("regular", kinds := [listed[kind] for kind in sorted(KINDS)]) != kinds:
            self.find(1, "wrong-counts", "FC-CLAIM-01")
        for point in self.claim.points:
            point.record, point.others, point.right, point.fit = None, [], False, None
            point.names = tuple(sorted({truth.name[row] for row in point.contact}))
            lists = all_lists(point)
            is_empty = any(not one for one in lists[2:])
            point.formed = not is_empty and all(len(set(one)) == len(one) for one in lists)
            if point.hull is None and point.index not in self.claim.indices:
                point.formed = False
                self.find(1, "malformed", "FC-CLAIM-12", point)
            elif not point.formed:
                self.find(1, "malformed", "FC-CLAIM-01", point)

    # ---- Which stationary point is meant

    def names(self, rows):
        return tuple(sorted({self.truth.name[row] for row in rows}))

    def where(self, names):
        return [self.truth.points[name] for name in names]

    def dimension(self, names):
        if len(names) < 4:
            return len(names) - 1
        return 3 if any(self.side(names, name) for name in names[3:]) else 2

    def side(self, plane, name):
        p = self.where([*plane[:3], name])
        return sign(det(minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0])))

    def placed(self, names):
        """The record with this contact set, or with its centre and a larger one (FC-CLAIM-02)."""
        if names in self.truth.at:
            return self.truth.records[self.truth.at[names]], "whole"
        around = self.truth.with_name.get(names[0], []) if names else []
        larger = [one for one in around if set(names) < set(one.contact)]
        center = sphere_through(self.where(names))[0] if larger else None
        for record in larger:
            if record.center == center:
                is_part = len(names) == record.hull + 1 and self.dimension(names) == record.hull
                return record, "part" if is_part else "other"
        return None, None

    def rank(self, point, record):
        if (point.index, point.index if point.hull is None else point.hull) == (record.index, record.hull):
            return 0
        return 1 if not record.critical and point.hull is None and record.index <= point.index <= record.hull else 2

    def candidates(self, point):
        within, nearly = [], []
        at = tuple(one[0] for one in point.center)
        for record in self.truth.records:
            reach = max(self.tolerance**2 * record.allowed, record.rounding)
            if (at[0] - record.center[0]) ** 2 > reach and not rounds_alike(at[0], record.center[0]):
                continue
            match = self.match_position(point.center, record)
            found = (self.rank(point, record), dot(minus(at, record.center), minus(at, record.center)), record.k)
            if match == "equal":
                return [found]
            if match != "off":
                (nearly if match == "rounding" else within).append(found)
        return sorted(within or nearly)

    def place_by_position(self, points):
        """As many claims as possible get a stationary point of their own, by Kuhn's algorithm."""
        options = {k: found for k, point in enumerate(points) if (found := self.candidates(point))}
        owner = {}

        def find_own(k, tried):
            for rank, _, record in options[k]:
                if rank == 0 and record not in tried:
                    tried.add(record)
                    if record not in owner or find_own(owner[record], tried):
                        owner[record] = k
                        return True
            return False

        for k in options:
            find_own(k, set())
        own = {k: record for record, k in owner.items()}
        for k, found in options.items():
            points[k].record, points[k].fit = self.truth.records[own.get(k, found[0][2])], "position"
            if len(found) > 1:
                points[k].others = [self.truth.records[one[2]] for one in found]
                self.vary(2, "ambiguous", "FC-CLAIM-05", points[k])

    # ---- Level 2: positions and distances (FC-CLAIM-05), and what is no stationary point (FC-CRIT-05)

    def match_position(self, claimed, record):
        pairs = list(zip(claimed, record.center))
        if all(value == true if exact else rounds_alike(value, true) for (value, exact), true in pairs):
            return "equal" if all(exact for _, exact in claimed) else "within"
        off = [0, 0]
        for (value, exact), true in pairs:
            off[exact] += (value - true) ** 2
        if not off[True] and off[False] <= self.tolerance**2 * record.allowed:
            return "within"
        return "rounding" if off[0] + off[1] <= record.rounding else "off"

    def match_squared(self, claimed, record):
        value, exact = claimed
        if value == record.squared:
            return "equal"
        allowed = self.tolerance**2 * record.allowed
        if not exact and (rounds_alike(value, record.squared) or roots_differ_by(value, record.squared, allowed)):
            return "within"
        return "rounding" if roots_differ_by(value, record.squared, record.rounding) else "off"

    def wrong_values(self, point, record):
        matches = [self.match_position(point.center, record)] if point.center else []
        matches += [self.match_squared(point.squared, record)] if point.squared else []
        if point.distance:
            matches.append(self.match_squared((point.distance[0] ** 2, point.distance[1]), record))
        return [one for one in matches if one in ("off", "rounding")]

    def wrong_doubles(self, point):
        record, matches = point.record, []
        for axis, claimed in enumerate(point.doubles or []):
            true = record.center[axis]
            if (claimed is None) != (nearest_double(true) is None):
                matches.append("off")
            elif claimed is not None:
                alone = SimpleNamespace(**{**vars(record), "center": (true, 0, 0)})
                matches.append(self.match_position([claimed, (0, True), (0, True)], alone))
        if point.squared_double != "none":
            if (point.squared_double is None) != (nearest_double(record.squared) is None):
                matches.append("off")
            elif point.squared_double is not None:
                matches.append(self.match_squared(point.squared_double, record))
        return [one for one in matches if one in ("off", "rounding")]

    def check_values(self, point):
        wrong = self.wrong_values(point, point.record)
        if any(not self.wrong_values(point, record) for record in point.others):
            wrong = []
        for clause, matches in (("FC-NUM-02", self.wrong_doubles(point)), ("FC-OUT-01", wrong)):
            for match in matches:
                self.find(2, "rounding" if match == "rounding" else "wrong-position", clause, point)

    def check_stray(self, point):
        if not point.names:
            return self.find(2, "wrong-position", "FC-CRIT-01", point)
        contact = self.where(point.names)
        center, squared = sphere_through(contact)
        allowed = TINY**2 * max(squared, max(abs(x) for x in center) ** 2)
        distances = [dot(minus(p, center), minus(p, center)) for p in self.truth.points]
        own = [distances[name] for name in point.names]
        nearest = min(distances)
        if any(one != squared for one in own):
            near = all(roots_differ_by(one, squared, allowed) for one in own)
            return self.find(2, "rounding" if near else "not-cospherical", "FC-CRIT-05 (a)", point)
        if nearest < squared:
            near = roots_differ_by(nearest, squared, allowed)
            return self.find(2, "rounding" if near else "ball-not-empty", "FC-CRIT-05 (b)", point)
        if len({self.truth.name[k] for k, one in enumerate(distances) if one == nearest}) > len(point.names):
            return self.find(2, "contact-incomplete", "FC-CRIT-05 (c)", point)
        driver = nearest_in_hull(contact, center)
        near = dot(minus(driver, center), minus(driver, center)) <= allowed
        return self.find(2, "rounding" if near else "outside-hull", "FC-CRIT-05 (d)", point)

    # ---- Levels 2 and 3 (FC-CLAIM-02 to 04)

    def check_points(self):
        formed = [point for point in self.claim.points if point.formed]
        for point in formed:
            if point.names:
                point.record, point.fit = self.placed(point.names)
        self.place_by_position([point for point in formed if not point.names])
        for point in formed:
            if point.record is None:
                self.check_stray(point)
        tells_regular = "regular" in self.claim.head or any(point.hull is not None for point in self.claim.points)
        for record in self.truth.records:
            here = [point for point in formed if point.record is record]
            if record.critical:
                self.check_critical(record, here)
            else:
                self.check_regular(record, here, tells_regular)
        if self.claim.indices == {0, 1, 2, 3}:
            n = self.claimed_counts
            if n[0] - n[1] + n[2] - n[3] != bool(self.truth.rows):
                self.find(3, "wrong-counts", "FC-INV-01")

    def accept(self, point):
        point.right = True
        if point.fit == "part":
            self.vary(2, "spanning-part", "FC-CLAIM-02", point)

    def check_critical(self, record, here):
        is_plain = not here or (len(here) == 1 and here[0].fit != "other")
        if not is_plain:
            made, impossible, again = self.sorted_claims(record, here)
            if not impossible and not again and self.makes(record, made):
                self.accept_perturbed(record, made)
                for point in here:
                    self.check_values(point)
                return
        first, addressed = None, False
        for point in here:
            has_index = point.hull is None and point.index == record.index
            if point.fit == "other":
                self.find(2, "contact-incomplete", "FC-CRIT-05 (c)", point)
                addressed = addressed or has_index
                continue
            addressed = True
            if not has_index:
                self.find(3, "wrong-index", "FC-CRIT-02", point)
            elif first:
                self.find(3, "claimed-twice", "FC-CRIT-06", point)
            else:
                first = point
                self.accept(point)
            self.check_values(point)
        if not addressed and record.index in self.claim.indices:
            reason = "missed-by-cluster" if len(record.contact) > record.hull + 1 else "missing"
            self.find(3, reason, "FC-CLAIM-03", contact=record.contact)

    def check_regular(self, record, here, tells_regular):
        regular = None
        for point in here:
            if point.hull is not None:
                if (point.index, point.hull) != (record.index, record.hull):
                    self.find(3, "wrong-index", "FC-CRIT-03", point)
                elif point.fit == "other":
                    self.find(2, "contact-incomplete", "FC-CRIT-05 (c)", point)
                else:
                    if regular:
                        self.find(3, "claimed-twice", "FC-CRIT-06", point)
                    else:
                        self.accept(point)
                    regular = point
            self.check_values(point)
        critical = [point for point in here if point.hull is None]
        if critical:
            made, impossible, again = self.sorted_claims(record, critical)
            for point in impossible:
                self.find(2, "collision-as-critical", "FC-CRIT-03", point)
            for point in again:
                self.find(3, "claimed-twice", "FC-CRIT-06", point)
            if made and not regular and self.makes(record, made):
                self.accept_perturbed(record, made)
            else:
                for point in made:
                    self.find(2, "collision-as-critical", "FC-CRIT-03", point)
        elif not here and tells_regular:
            self.find(3, "symbolic-perturbation", "FC-CLAIM-04", permitted=True, contact=record.contact)

    # ---- What a perturbation makes (FC-CLAIM-04)

    def accept_perturbed(self, record, made):
        self.perturbed[record.k] = made
        self.undecided = self.undecided or not self.is_simplex(record)
        for point in made:
            point.right = True
            self.vary(2, "symbolic-perturbation", "FC-CLAIM-04", point)

    @staticmethod
    def is_simplex(record):
        return len(record.contact) == record.hull + 1

    def outcomes(self, record):
        """All that perturbations make of a simplex: lists of contact sets."""
        contact = record.contact
        if record.critical:
            made = [[contact]]
        else:
            faces = itertools.combinations(contact, record.index + 1)
            face = next(one for one in faces if in_hull(self.where(one), record.center))
            made = [[face, contact]]
            if (record.index, record.hull) == (1, 3):
                rest = [name for name in contact if name not in face]
                one, other = (tuple(sorted((*face, name))) for name in rest)
                a, r, s = (minus(p, record.center) for p in self.where([face[0], *rest]))
                cosine = dot(r, s) * dot(a, a) - dot(r, a) * dot(s, a)
                made = [[face, one, other, contact]]
                made += [[face, one], [face, other]] if cosine >= 0 else []
                made += [[one, contact], [other, contact]] if cosine <= 0 else []
        return [[names for names in some if len(names) - 1 in self.claim.indices] for some in made]

    def opposite_pairs(self, record):
        samples = set(self.where(record.contact))
        return sum(tuple(2 * x - y for x, y in zip(record.center, p)) in samples for p in samples) // 2

    def is_face(self, record, names):
        """Whether they are all of C(x) that is in one plane, with the rest of C(x) on one side."""
        sides = {name: self.side(names, name) for name in record.contact}
        return len(set(sides.values()) - {0}) == 1 and tuple(n for n, s in sides.items() if not s) == names

    def can_make(self, record, point):
        if point.hull is not None or not 1 <= point.index <= 3:
            return False
        names, index = point.names, point.index
        if self.is_simplex(record):
            return any(len(one) - 1 == index and names in ((), one) for some in self.outcomes(record) for one in some)
        if not names:
            return index > 1 or self.opposite_pairs(record) > 0
        is_face = index == record.hull if names == record.contact else (
            index == 2 and record.hull == 3 and len(names) > 2 and self.dimension(names) == 2 and
            self.is_face(record, names))
        fits = set(names) <= set(record.contact) and (len(names) == index + 1 or is_face)
        return fits and in_hull(self.where(names), record.center)

    def sorted_claims(self, record, here):
        made, impossible, again = {1: [], 2: [], 3: []}, [], []
        for point in here:
            if not self.can_make(record, point):
                impossible.append(point)
                continue
            same = made[point.index]
            if self.is_simplex(record):
                most = 2 if (record.index, record.hull, point.index) == (1, 3, 2) else 1
            else:
                most = self.opposite_pairs(record) if point.index == 1 else len(here)
            is_again = len(same) >= most or (point.names and any(point.names == other.names for other in same))
            (again if is_again else same).append(point)
        return made[1] + made[2] + made[3], impossible, again

    def makes(self, record, made):
        if self.is_simplex(record):
            return any(self.is_outcome(some, made) for some in self.outcomes(record))
        total = sum(1 if point.index % 2 == 0 else -1 for point in made)
        right = 0 if not record.critical else 1 if record.index % 2 == 0 else -1
        all_judged = self.claim.indices == {0, 1, 2, 3}
        needs_own = record.critical and record.index in self.claim.indices
        has_own = any(point.index == record.index for point in made)
        return (total == right or not all_judged) and (has_own or not needs_own) and not self.overlap(record, made)

    @staticmethod
    def is_outcome(some, made):
        indices = Counter(len(one) - 1 for one in some) == Counter(point.index for point in made)
        return indices and all(not point.names or point.names in some for point in made)

    def overlap(self, record, made):
        """Conditions (f) and (g)."""
        whole_ones = [p for p in made if p.names == record.contact and p.index == record.hull]
        around = 0
        for point in made:
            if not point.names or point in whole_ones:
                continue
            if whole_ones and not self.is_on_face(record, point):
                return True
            if point.index == 3 and len(point.names) == 4 and self.dimension(point.names) == 3:
                triangles = itertools.combinations(point.names, 3)
                around += not any(in_hull(self.where(one), record.center) for one in triangles)
        return around > 1

    def is_on_face(self, record, point):
        if point.index == 1:
            return record.index == 1
        sides = {self.side(point.names, name) for name in record.contact} - {0}
        return point.index == 2 and record.hull == 3 and len(sides) < 2

    # ---- Level 4 (FC-CLAIM-06, 07, 09)

    def check_incidences(self, point):
        if not point.right or point.hull is not None:
            return False
        has_samples = point.samples is not None and point.index == 1 and 0 in self.claim.indices
        has_boundary = point.boundary is not None and 1 in self.claim.indices
        has_targets = point.targets is not None and (point.index == 3 or point.index + 1 in self.claim.indices)
        if has_samples:
            self.check_samples(point)
        if (has_boundary or has_targets) and point.record.k in self.perturbed:
            return has_samples
        if has_boundary:
            self.check_boundary(point)
        if has_targets:
            [self.check_edges, self.check_saddles, self.check_limits, self.check_nothing][point.index](point)
        return has_samples or has_boundary or has_targets

    def is_made(self, record, names, index=None):
        return any((index is None or point.index == index) and point.names in ((), names)
                   for point in self.perturbed.get(record.k, []))

    def target(self, rows):
        """Whether it is known, the place of its record (None: infinity), and how it fits."""
        if rows is None:
            return True, None, "whole"
        names = self.names(rows)
        record, fit = self.placed(names)
        if record is None:
            return False, None, "other"
        return True, record.k, "made" if fit != "whole" and self.is_made(record, names) else fit

    def check_samples(self, point):
        names, record = self.names(point.samples), point.record
        if record.k not in self.perturbed:
            right = names == record.contact
        else:
            right = names == point.names if point.names else len(names) == 2 and self.placed(names)[0] is record
        if not right:
            self.find(4, "wrong-incidence", "FC-FLOW-07", point)

    def check_edges(self, point):
        name = point.record.contact[0]
        edges = {r.k for r in self.truth.with_name[name] if (r.index, r.hull) == (1, 1)}
        missing, seen, wrong, varies = set(edges), set(), False, False
        for rows in point.targets:
            _, k, _ = self.target(rows)
            if k is not None and (k in seen or k in missing):
                missing.discard(k)
            elif k is not None and len(names := self.names(rows)) == 2 and name in names and \
                    self.is_made(self.truth.records[k], names, 1):
                varies = True
            else:
                wrong = True
            seen.add(k)
        if wrong or missing:
            self.find(4, "wrong-incidence", "FC-FLOW-07", point)
        elif varies:
            self.vary(4, "symbolic-perturbation", "FC-CLAIM-04", point)

    def check_saddles(self, point):
        record, records = point.record, self.truth.records
        above = {r.k for r in records if list(record.contact) in r.told.get("ends", [])}
        missing, seen, wrong, reasons, infinity = set(above), set(), False, set(), False
        for rows in point.targets:
            if rows is None and not above:
                infinity = True
                continue
            _, k, fit = self.target(rows)
            if k is not None and k in seen:
                continue
            seen.add(k)
            if k is not None and fit != "other" and k in missing:
                missing.discard(k)
                reasons |= {"part": {"spanning-part"}, "made": {"symbolic-perturbation"}}.get(fit, set())
            elif k is not None and (why := self.why_down(records[k], record)):
                reasons.add(why)
            else:
                wrong = True
        for k in sorted(missing):
            if k in self.perturbed or self.truth.has_tie(k):
                missing.discard(k)
                reasons.add("symbolic-perturbation" if k in self.perturbed else "tie-break")
        if wrong or missing:
            self.find(4, "wrong-incidence", "FC-CHAIN-01", point)
        elif reasons:
            worst = max(reasons, key=["spanning-part", "tie-break", "symbolic-perturbation"].index)
            self.vary(4, worst, "FC-CLAIM-02" if worst == "spanning-part" else "FC-CLAIM-09", point)
        if infinity and None not in (limits := self.truth.limits(record.k)):
            if any(self.may_end(None, one) for one in limits):
                self.vary(4, "symbolic-perturbation", "FC-CLAIM-07", point)
            else:
                self.find(4, "wrong-incidence", "FC-CLAIM-06", point)

    def why_down(self, saddle, edge):
        if saddle.squared <= edge.squared:
            return None
        if not saddle.critical or saddle.k in self.perturbed:
            return "symbolic-perturbation"
        return "tie-break" if saddle.index == 2 and self.truth.has_tie(saddle.k) else None

    def check_limits(self, point):
        true = self.truth.limits(point.record.k)
        if point.fit == "part" and self.turns(point.names, point.record.contact):
            true.reverse()
        targets = [self.target(rows) for rows in point.targets]
        known = all(one[0] for one in targets)
        limits, fits = [one[1] for one in targets], {one[2] for one in targets}
        is_same = limits == true if point.by_side else set(limits) == set(true)
        if known and is_same and not fits & {"other", "made"}:
            if "part" in fits:
                self.vary(4, "spanning-part", "FC-CLAIM-02", point)
        elif known and "other" not in fits and self.permitted(limits, true, point.by_side):
            self.vary(4, "symbolic-perturbation", "FC-CLAIM-07", point)
        else:
            self.find(4, "wrong-incidence", "FC-FLOW-07", point)

    def turns(self, names, contact):
        a, b = ((cross(minus(q, p), minus(r, p))) for p, q, r in (self.where(some[:3]) for some in (names, contact)))
        return dot(a, b) <= 0

    def permitted(self, limits, true, by_side):
        if by_side:
            return all(map(self.may_end, limits, true))
        some = list(dict.fromkeys(limits))
        if not 1 <= len(some) <= 2:
            return False
        return any(all(map(self.may_end, (some[0], some[-1]), order)) for order in (true, true[::-1]))

    def may_end(self, target, true):
        """Whether a perturbation can make an orbit that ends at `true` end at the target."""
        limits, beyond = self.continuations(true)
        if target in limits:
            return True
        record = self.truth.records[target] if target is not None else None
        return beyond is not None and (record is None or (record.hull >= 2 and record.squared > beyond))

    def continuations(self, at):
        if at not in self.memo:
            limits, beyond, record = {at}, [], self.truth.records[at] if at is not None else None
            if record and record.critical and record.index == 2:
                for one in self.truth.limits(at):
                    more, least = self.continuations(one)
                    limits |= more
                    beyond += [] if least is None else [least]
            elif record and not record.critical:
                beyond = [record.squared]
            self.memo[at] = limits, min(beyond, default=None)
        return self.memo[at]

    def check_nothing(self, point):
        for _ in filter(lambda rows: rows is not None, point.targets):
            self.find(4, "wrong-incidence", "FC-FLOW-03", point)

    def check_boundary(self, point):
        record, odd, seen, degrees, has_regular = point.record, set(), set(), Counter(), False
        for rows in point.boundary:
            names = self.names(rows)
            edge, _ = self.placed(names)
            made = edge is not None and self.is_made(edge, names, 1)
            if edge is None or len(names) != 2 or (edge.index != 1 and not made) or \
                    edge.squared >= record.squared or edge.k in seen:
                return self.find(4, "wrong-incidence", "FC-CHAIN-01", point)
            seen.add(edge.k)
            has_regular = has_regular or made or not edge.critical
            odd ^= {edge.k}
            degrees.update(names)
        told = record.told["boundary"]
        if told is not None and odd == {self.truth.at[tuple(one)] for one in told}:
            return None
        if told is not None or any(n % 2 for n in degrees.values()):
            return self.find(4, "wrong-incidence", "FC-CHAIN-01", point)
        # The vectors break no ties, so it is not judged which of the cycles is claimed.
        return self.vary(4, "symbolic-perturbation", "FC-CLAIM-09", point) if has_regular else None


def nearest_in_hull(points, center):
    """The centre of the smallest ball around points of one sphere: the point of their hull nearest to its centre."""
    best = None
    for size in range(1, 5):
        for some in itertools.combinations(points, size):
            x, squared = sphere_through(list(some))
            if in_hull(list(some), x) and all(dot(minus(p, x), minus(p, x)) <= squared for p in points):
                if best is None or squared < best[1]:
                    best = x, squared
        if best:
            return best[0]
    raise AssertionError("every set of points has a smallest ball")


# ---- Profiles (FC-CLAIM-22). Of each part it is known whether it is told (True), or left out (False), or whether there
# is nothing to tell of it (None).


def profile_of(claim, indices, highest):
    def told(key):
        saddles = [point for point in claim.points if point.hull is None and point.index == 2]
        if highest < 4 or indices != {0, 1, 2, 3}:
            return False
        return all(getattr(point, key) is not None for point in saddles) if saddles else None

    def is_exact(point):
        numbers = [*(point.center or []), *filter(None, (point.squared, point.distance))]
        return all(exact for _, exact in numbers)

    return {"parts": {"points": highest >= 3, "U2": told("targets"), "S2": told("boundary"), "orbits": None},
            "indices": set(indices), "exact": all(map(is_exact, claim.points))}


def joined_profile(profiles):
    joined = {"parts": {}, "indices": {0, 1, 2, 3}, "exact": True}
    for profile in profiles:
        for part, is_told in profile["parts"].items():
            states = {is_told, joined["parts"].get(part)}
            joined["parts"][part] = False if False in states else True if True in states else None
        joined["indices"] &= profile["indices"]
        joined["exact"] = joined["exact"] and profile["exact"]
    return joined


def statement(verdict, profile):
    """What `flowcert check` says of it. None if nothing is told."""
    if verdict == FAILS:
        return f"does not conform to {VERSION}"
    parts = [part for part, is_told in profile["parts"].items() if is_told]
    if "points" in parts and profile["indices"] != {0, 1, 2, 3}:
        some = ", ".join(map(str, sorted(profile["indices"])))
        parts[0:1] = [f"points of index {some}"] if some else []
    words = {CONFORMS: "conforms to", DETERMINED: "conforms where determined to", PERTURBED: "is perturbed under"}
    grade = "exact" if profile["exact"] else "approximate"
    return f"{words[verdict]} {VERSION}, {' + '.join(parts)}, {grade}" if parts else None


# ---- Orbits (formats/orbit.md)


def rational(value):
    parts = isinstance(value, str) and not isinstance(value, Literal) and re.fullmatch(r"-?\d+(?:/-?\d+)?", value)
    require(parts and not re.search(r"/-?0+$", value), f"no rational: {str(value)[:40]}")
    over, _, under = value.partition("/")
    return Fraction(int(over), int(under or 1))


def read_segment(value):
    require(isinstance(value["type"], str) and not isinstance(value["type"], Literal), "a type that is no string")
    contacts = [None if value.get(key) is None else sorted(ids(value[key]))
                for key in ("start_contact", "crossed_contact", "end_contact")]
    end = None if value["end"] is None else three(value["end"], rational)
    return [value["type"], three(value["driver"], rational), end, *contacts]


def read_orbit(data):
    require(data is not None, "there is no answer, or one of more than 16 MiB")
    try:
        value = parse(data.decode("utf-8", "replace"))
        require(isinstance(value["segments"], list), "'segments' is no array")
        segments, limit = [read_segment(one) for one in value["segments"]], value["limit"]
        if limit["kind"] == "infinity":
            return segments, None
        index = limit["index"]
        require(isinstance(index, (Literal, list)), f"not an index: {index}")
        return segments, [limit["kind"], index, three(limit["position"], rational), sorted(ids(limit["contact"])),
                          rational(limit["squared_distance"])]
    except (AttributeError, TypeError, KeyError, IndexError) as error:
        raise Unreadable(f"not as the format says: {error!r}") from error


def is_same_segment(claimed, true, is_arrival_free):
    pairs = list(zip(claimed, true))
    if is_arrival_free:  # neither the last letter of the type nor the contact set of the end
        pairs = [(claimed[0][:4], true[0][:4]), *pairs[1:5]]
    return all(one == other or (one is None and k > 2) for k, (one, other) in enumerate(pairs))


def match_orbit(claimed, true):
    """CONFORMS, PERTURBED or FAILS. An orbit may go on where the true one ends at a regular point (FC-CLAIM-07, 08)."""
    (ours, limit), (theirs, end) = claimed, true
    if len(ours) == len(theirs) and limit == end and all(is_same_segment(*pair, False) for pair in zip(ours, theirs)):
        return CONFORMS
    is_free = end is not None and end[0] == "regular" and len(ours) >= len(theirs)
    last = len(theirs) - 1
    if is_free and all(is_same_segment(*pair, k == last) for k, pair in enumerate(zip(ours, theirs))):
        return PERTURBED
    return FAILS


# ---- Cases and commands


def decimal_word(word):
    try:
        return repr(float(hexadecimal(word))) if "0x" in word else word
    except Unreadable:
        return word


def points_text(case, as_they_are):
    if "text" in case:
        return case["text"]
    lines = [" ".join(row if as_they_are else map(decimal_word, row)) for row in case["points"]]
    return "\n".join(lines) + "\n" if lines else "# no points\n"


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (4096 << 20,) * 2)
    resource.setrlimit(resource.RLIMIT_FSIZE, (64 << 20,) * 2)


def run_command(command, text, seconds, start="1,0,0"):
    """How it ends, what it answers, and what it said: a word of COLUMNS or an exit status, bytes, and a line."""
    with tempfile.TemporaryDirectory(prefix="judge-") as folder:
        points, claim = Path(folder, "points.xyz"), Path(folder, "claim")
        points.write_text(text, newline="")
        places = {"{in}": str(points), "{out}": str(claim), "{start}": start}
        order = re.sub(r"\{(?:in|out|start)\}", lambda place: shlex.quote(places[place[0]]), command)
        answer = claim if "{out}" in command else Path(folder, "stdout")
        said = Path(folder, "stderr")
        with open(Path(folder, "stdout"), "wb") as out, open(said, "wb") as log, open(os.devnull, "rb") as nothing:
            run = subprocess.Popen(["/bin/sh", "-c", order], cwd=folder, stdin=nothing, stdout=out,
                                   stderr=log, start_new_session=True, preexec_fn=limit_memory)
            try:
                status = run.wait(seconds)
            except subprocess.TimeoutExpired:
                status = "timed out"
            try:
                os.killpg(run.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            run.wait()
        note = "" if status in (0, "timed out") else f"exit status {status}{last_line(said)}"
        if status != "timed out" and (status < 0 or status in (126, 127) or status > 128):
            status = "crashed"
        is_there = answer.is_file() and answer.stat().st_size <= 16 << 20
        return status, answer.read_bytes() if is_there else None, note


def last_line(log):
    """What a program said last on standard error, without characters that move a terminal's cursor."""
    with open(log, "rb") as file:
        file.seek(max(0, log.stat().st_size - 4096))
        lines = file.read().decode(errors="replace").split("\n")
    said = next((line for line in reversed(lines) if line.strip()), "")
    shown = "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in said)
    return f": {shown[:160]}" if said else ""


BLANK = {"message": "", "findings": [], "judged": set(), "undecided": False, "profile": None, "orbits": []}


def judge_bytes(case, data, options):
    try:
        require(data is not None, "there is no answer, or one of more than 16 MiB")
        truth = Truth(case)
        claim = read_claim(data, len(truth.rows))
    except Unreadable as error:
        return {**BLANK, "outcome": "unreadable", "message": str(error)}
    judge = Judge(truth, claim, options.tolerance, options.levels)
    verdict = judge.run()
    return {**BLANK, "outcome": verdict, "findings": judge.findings, "judged": judge.judged,
            "undecided": judge.undecided, "profile": profile_of(claim, claim.indices, options.levels)}


def judge_orbits(case, result, options):
    """Adds to the result what the orbits of the case make of it. The first negative outcome stays."""
    for true in case["expected"].get("orbits", []):
        start = ",".join(true["start"])
        text = points_text(case, options.hex)
        status, data, message = run_command(options.orbits_against, text, options.time_limit, start)
        outcome = status if isinstance(status, str) else "refused" if status else ""
        if not outcome:
            try:
                outcome = match_orbit(read_orbit(data), read_orbit(json.dumps(true).encode()))
                result["orbits"] = [*result["orbits"], {"start": start, "outcome": outcome}]
                message = "" if outcome == CONFORMS else f"another orbit from {start}"
            except Unreadable as error:
                outcome, message = "unreadable", str(error)
        if is_negative(outcome) and not is_negative(result["outcome"]) or \
                outcome == PERTURBED and result["outcome"] in (CONFORMS, DETERMINED):
            result["outcome"], result["message"] = outcome, message
        if outcome not in GOOD and outcome != FAILS:
            return
    if result["profile"] and result["orbits"]:
        result["profile"]["parts"]["orbits"] = True


def judge_case(case, options):
    text = points_text(case, options.hex)
    if case.get("refused") == "start" and not options.orbits_against:
        return {**BLANK, "outcome": "skipped"}
    if case.get("refused") == "start":
        status, data, note = run_command(options.orbits_against, text, options.time_limit, ",".join(case["start"]))
    else:
        status, data, note = run_command(options.against, text, options.time_limit)
    if isinstance(status, str):
        result = {**BLANK, "outcome": status, "message": note}
    elif case["result"] == "invalid":
        result = {**BLANK, "outcome": "properly refused" if status else "accepted"}
    else:
        result = {**BLANK, "outcome": "refused", "message": note} if status else judge_bytes(case, data, options)
    if options.orbits_against and case["result"] != "invalid":
        judge_orbits(case, result, options)
    return result


def is_negative(outcome):
    return outcome not in (*GOOD, "properly refused", "skipped")


# ---- Reports


def table(title, names, outcomes):
    rows = []
    for name, cases in names:
        count = Counter(COLUMN_OF.get(outcomes[one["id"]]["outcome"], outcomes[one["id"]]["outcome"]) for one in cases)
        rows.append([name, len(cases) - count["skipped"], *(count[column] for column in COLUMNS)])
    kept = [0, 1, 2] + [k for k in range(3, len(COLUMNS) + 2) if any(row[k] for row in rows)]
    texts = [[[title, "cases", *COLUMNS][k] for k in kept]] + [[str(row[k]) for k in kept] for row in rows]
    widths = [max(len(row[k]) for row in texts) for k in range(len(kept))]
    half = (len(kept) + 1) // 2
    is_wide = sum(widths) + 2 * len(widths) > 80
    parts = [range(1, half), range(half, len(kept))] if is_wide else [range(1, len(kept))]
    blocks = ["\n".join("  " + "  ".join([row[0].ljust(widths[0])] + [row[k].rjust(widths[k]) for k in part])
                        for row in texts) for part in parts]
    return "\n\n".join(blocks) + "\n"


def print_negative(case, outcome):
    message = f": {outcome['message']}" if outcome["message"] else ""
    print(f"{case['id']} ({case['comment']}): {outcome['outcome']}{message}")
    for one in [one for one in outcome["findings"] if not one["permitted"]][:3]:
        place = f"line {one['line']}" if one["line"] else "the contact set {}".format(one["contact"] or "of no point")
        print(f"  level {one['level']}: {one['reason']} [{one['clause']}]: {place}")


def print_report(cases, flags, outcomes, options):
    negative = [case for case in cases if is_negative(outcomes[case["id"]]["outcome"])]
    for case in negative[:options.most]:
        print_negative(case, outcomes[case["id"]])
    if negative:
        print(f"and {len(negative) - options.most} more\n" if len(negative) > options.most else "")
    by_flag = [(flag, [one for one in cases if flag in one["flags"]]) for flag in flags]
    run = {case["id"] for case in cases if outcomes[case["id"]]["outcome"] != "skipped"}
    print(table("flag", [pair for pair in by_flag if any(one["id"] in run for one in pair[1])], outcomes))
    groups = list(dict.fromkeys(case["group"] for case in cases))
    print(table("group", [(group, [one for one in cases if one["group"] == group]) for group in groups], outcomes))
    counts = Counter(outcome["outcome"] for outcome in outcomes.values())
    levels = Counter(level for outcome in outcomes.values() for level in outcome["judged"])
    print("judged: " + ", ".join(f"{levels[k]} claims on level {k}" for k in range(1, options.levels + 1)))
    for word, name in (("skipped", "skipped"), (None, "not decided")):
        number_of = counts[word] if word else sum(outcome["undecided"] for outcome in outcomes.values())
        if number_of:
            print(f"{name}: {number_of} cases")
    if orbits := sum(len(outcome["orbits"]) for outcome in outcomes.values()):
        print(f"judged: {orbits} orbits")
    good = counts[CONFORMS] + counts["properly refused"]
    print(f"\n{len(cases) - counts['skipped']} cases: {good} conform, {counts[DETERMINED]} where determined, "
          f"{counts[PERTURBED]} perturbed, {len(negative)} negative")
    if said := statement_of_all(outcomes, options):
        print(said)


def statement_of_all(outcomes, options):
    """The statement of FC-CLAIM-22, with the number of vectors that it is about."""
    verdicts = [one["outcome"] for one in outcomes.values() if one["outcome"] not in ("skipped", "properly refused")]
    worst = FAILS if any(map(is_negative, verdicts)) else max(verdicts, key=GOOD.index, default=CONFORMS)
    said = statement(worst, joined_profile(filter(None, (one["profile"] for one in outcomes.values()))))
    asked = sum(one["outcome"] != "skipped" for one in outcomes.values())
    number_of = f"{asked:,}" if asked == options.vectors_in_all else f"{asked:,} of {options.vectors_in_all:,}"
    return said and f"{said} ({number_of} vectors)"


def read_vectors(folder, options):
    flags = [one["flag"] for one in json.loads(Path(folder, "flags.json").read_text())["flags"]]
    cases = []
    for path in sorted(Path(folder).glob("*.json")):
        if path.name != "flags.json":
            group = json.loads(path.read_text())
            cases += [{**case, "group": group["group"]} for case in group["cases"]]
    options.vectors_in_all = len(cases)
    options.groups = sorted({case["group"] for case in cases})
    chosen = [case for case in cases if (not options.group or case["group"] in options.group)
              and (not options.case or case["id"] in options.case)
              and (not options.flag or set(options.flag) & set(case["flags"]))]
    return chosen, flags


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--against", help="the command: {in} is a file of points, {out} that of the claim; it runs in "
                        "a folder of its own, so give whole paths")
    parser.add_argument("--orbits-against", help="a command for orbits: {start} is where one starts, X,Y,Z")
    parser.add_argument("--claim", help="a claim about the points of one --case, instead of a command")
    parser.add_argument("--vectors", default=str(Path(__file__).parent / "vectors"), help="folder of the vectors")
    for name in ("--group", "--flag", "--case"):
        parser.add_argument(name, action="append", default=[], help="only such cases; may be given several times")
    parser.add_argument("--tolerance", type=Fraction, default=Fraction(1e-9), help="of decimals (FC-CLAIM-05)")
    parser.add_argument("--levels", type=int, choices=[1, 2, 3, 4], default=4, help="judge levels 1 to this one")
    parser.add_argument("--time-limit", type=float, default=10, help="seconds after which a run is killed")
    parser.add_argument("--most", type=int, default=10, help="show so many negative cases")
    parser.add_argument("--hex", action="store_true", help="points as hexadecimal floats, not as shortest decimals")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    options = parser.parse_args()
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # a reader that has seen enough may close the pipe
    if not 0 <= options.tolerance <= Fraction(1, 1000) or bool(options.against) == bool(options.claim):
        parser.error("needs --against or --claim, and a tolerance from 0 to 0.001")
    if options.orbits_against and (options.claim or "{start}" not in options.orbits_against):
        parser.error("--orbits-against needs {start} in its command, and --against beside it")
    cases, flags = read_vectors(options.vectors, options)
    if not cases or (options.claim and (len(cases) > 1 or cases[0]["result"] == "invalid")):
        parser.error("--claim needs one --case that is not invalid" if cases else
                     f"no such case; the groups are {', '.join(options.groups)}, and the flags {', '.join(flags)}")
    if options.claim:
        outcomes = {cases[0]["id"]: judge_bytes(cases[0], Path(options.claim).read_bytes(), options)}
    else:
        for command in filter(None, (options.against, options.orbits_against)):
            if run_command(command, "0 0 0\n2 0 0\n", options.time_limit)[0] == "crashed":
                parser.error(f"the command cannot be run: {command}")
        outcomes = {case["id"]: judge_case(case, options) for case in cases}
    if options.json:
        keep = ("outcome", "message", "findings", "undecided", "orbits")
        print(json.dumps({"cases": [{"id": case["id"], **{key: outcomes[case["id"]][key] for key in keep},
                                     "judged": sorted(outcomes[case["id"]]["judged"])} for case in cases],
                          "statement": statement_of_all(outcomes, options),
                          "own_seconds": resource.getrusage(resource.RUSAGE_SELF).ru_utime}))
    else:
        print_report(cases, flags, outcomes, options)
    return 1 if any(is_negative(one["outcome"]) for one in outcomes.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
