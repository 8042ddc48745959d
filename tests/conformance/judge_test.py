#!/usr/bin/env python3
"""judge_test.py

The tests of spec/judge.py and spec/read_claim.py that need no build: how it reads claims, what it says of the
judgements of spec/judgements.json and of right claims about vectors, how it follows orbits, and how it runs commands.
The environment's JUDGE is another folder of these two, one of them a mutant (tests/mutants/judge_py.py).
"""
# CITES: FC-FILE-12 FC-FILE-13 FC-FILE-15 FC-FILE-16 FC-FILE-18 FC-FILE-19 FC-FILE-26 FC-FILE-27 FC-FILE-29 FC-FILE-47
# CITES: FC-CLAIM-22 FC-CLAIM-23 FC-CLAIM-24
import contextlib
import gzip
import io
import itertools
import json
import os
import signal
import sys
import tempfile
import time
import unittest
import unittest.mock
from collections import Counter
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import judgements_test

SPEC = Path(__file__).parents[2] / "spec"


sys.path.insert(0, os.environ.get("JUDGE", str(SPEC)))
import judge  # noqa: E402

GROUPS = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((SPEC / "vectors").glob("*.json"))]
CASES = {case["id"]: case for group in GROUPS for case in group.get("cases", [])}
HEADER = '{"format": "flowcert-stationary-points", "format_version": 1}'
TRIANGLE = CASES["critical-points-0002"]  # 0 0 0, 4 0 0, 1 3 0


def judged(case, data, tolerance=1e-9, highest_level=4):
    options = SimpleNamespace(tolerance=tolerance, highest_level=highest_level)
    return judge.judge_bytes(case, data if isinstance(data, bytes) else data.encode(), options)


def verdict(case, data, **options):
    return judged(case, data, **options)["outcome"]


def reasons(case, data, **options):
    return sorted((one["level"], one["reason"], one["line"]) for one in judged(case, data, **options)["findings"])


def nearest(text):
    try:
        return float(Fraction(text))
    except OverflowError:
        return None


def header_of(case):
    expected = case["expected"]
    return {"format": "flowcert-stationary-points", "format_version": 1, "points": len(case["points"]),
            "merged_duplicates": expected["merged_duplicates"], "critical": expected["critical"],
            "regular_stationary": expected["regular_stationary"]}


def right_records(case):
    """The records of a right claim about a case, on the levels 1 to 4."""
    records = []
    for one in case["expected"]["stationary"]:
        record = {key: one[key] for key in ("index", "kind", "contact", "center", "squared_distance")}
        record["center_double"] = [nearest(x) for x in one["center"]]
        record["squared_distance_double"] = nearest(one["squared_distance"])
        told = one.get("incidences", {})
        if one["index"] == 1:
            record["samples"] = one["contact"]
        if one["index"] == 2:
            record["limits"] = told["limits"]
            record.update({"stable": {"boundary": told["boundary"]}} if told["boundary"] is not None else {})
        records.append(record)
    return records


def text_of(*lines):
    return "".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines)


def of_triangle(change, head=HEADER):
    """A right claim about the triangle, its records changed."""
    records = json.loads(json.dumps(right_records(TRIANGLE)))
    change(records)
    return text_of(head, *records)


class Numbers(unittest.TestCase):
    def test_numbers_are_read_by_one_grammar(self):
        for text, value, exact in [
                ("5", 5, False), ("+5", 5, False), ("-5", -5, False), ("007", 7, False), (".5", "1/2", False),
                ("5.", 5, False), ("5.e1", 50, False), ("1e+2", 100, False), ("1E-2", "1/100", False),
                ("-.5e01", -5, False), ("1e700", 10**700, False), ("1e-700", Fraction(1, 10**700), False),
                ("3/4", "3/4", True), ("+3/4", "3/4", True), ("-6/008", "-3/4", True), ("0/5", 0, True),
                ("0x1", 1, True), ("-0X.8", "-1/2", True), ("0x1.", 1, True), ("0xA.8p1", 21, True),
                ("+0x1p-1074", Fraction(1, 2**1074), True), ("0x1.fffffffffffffp1023", 2**1024 - 2**971, True),
                ("0x0p99999", 0, True), ("0x10000000000000000000000p-88", 1, True), ("0x1P+3", 8, True),
                ("0x1fffffffffffff", 2**53 - 1, True), ("0x10p1019", 2**1023, True),
                ("0x10p-1078", Fraction(1, 2**1074), True)]:
            self.assertEqual(judge.number(text), (Fraction(value), exact), text)

    def test_plain_integers_are_exact_in_strings(self):
        for text, exact in [("5", True), ("-5", True), ("+0", True), ("5.", False), (".5", False), ("5e0", False)]:
            self.assertEqual(judge.number(text, plain_is_exact=True)[1], exact, text)
        self.assertTrue(judge.number("1" * 3000, plain_is_exact=True)[1])
        self.assertTrue(judge.number("0x" + "0" * 3000)[1])

    def test_what_is_no_number_is_refused(self):
        for text in ["", ".", "+", "-", "e5", "5e", "5e+", "1.2.3", "--5", "+-5", "5 ", " 5", "1_000", "1,5", "nan",
                     "inf", "-Infinity", "0x", "0x.", "0xp1", "0x1p", "0x1.1.1", "1x5", "1/0", "1/-2", "1/+2", "1/2/3",
                     "1/", "/2", "1.0/2", "0x1/2", "\u0661", "\u06615", "1/\u0662", "\u00b2", "0x\uff11", "5\n",
                     "1e701",
                     "1e-701", "1e\u0661", "0x1p1024", "0x1p-1075", "0x1.00000000000001p0", "0x1.8p-1074",
                     "0x3fffffffffffff", "0x10p1020", "0x10p-1079", "1" * 2001, "1" * 1000001 + "/1"]:
            with self.assertRaises(judge.Unreadable, msg=text[:40]):
                judge.number(text)
        with self.assertRaises(judge.Unreadable):
            judge.number("1" * 1000001, plain_is_exact=True)

    def test_the_longest_numbers_are_read(self):
        self.assertEqual(judge.number("1" * 2000)[0], int("1" * 2000))
        self.assertEqual(judge.number("0" * 999999 + "1", plain_is_exact=True)[0], 1)

    def test_distances_of_roots(self):
        for a, b, length, near in [(4, 9, 1, True), (4, 9, Fraction(99, 100), False), (9, 4, 1, True), (1, 1, 0, True),
                                   (0, 1, 1, True), (0, 1, Fraction(1, 2), False), (0, 0, 0, True), (1, 4, 25, True)]:
            self.assertEqual(judge.roots_differ_by(Fraction(a), Fraction(b), Fraction(length)), near, (a, b, length))


    def test_what_is_out_of_the_range_of_doubles_rounds_to_nothing(self):
        for a, b, is_alike in [(1, 1 + Fraction(1, 2**60), True), (1, 1 + Fraction(1, 2**50), False),
                               (10**400, 10**400 + 1, False), (1, 10**400, False)]:
            self.assertEqual(judge.rounds_alike(Fraction(a), Fraction(b)), is_alike)


class Geometry(unittest.TestCase):
    def test_spheres_through_points_on_lines(self):
        for points, center, squared in [([(3, 1, 2)], (3, 1, 2), 0), ([(0, 0, 0), (2, 0, 0)], (1, 0, 0), 1),
                                        ([(0, 0, 0), (2, 0, 0), (6, 0, 0)], (1, 0, 0), 1),
                                        ([(0, 0, 0), (2, 0, 0), (6, 0, 0), (0, 4, 0)], (1, 2, 0), 5),
                                        ([(0, 0, 0), (2, 0, 0), (0, 4, 0), (2, 4, 0), (0, 0, 6)], (1, 2, 3), 14)]:
            found = judge.sphere_through([tuple(map(Fraction, one)) for one in points])
            self.assertEqual(found, (center, squared), points)

    def test_hulls_of_points_on_a_circle(self):
        """Of twelve points around their centre, of which each has an opposite one."""
        circle = [(5, 0, 0), (4, 3, 0), (3, 4, 0), (0, 5, 0), (-3, 4, 0), (-4, 3, 0)]
        circle += [tuple(-x for x in one) for one in circle]
        for places in itertools.permutations(range(12), 3):
            a, b, c = sorted(places)
            owed = max(b - a, c - b, a + 12 - c) <= 6
            self.assertEqual(judge.in_hull([circle[k] for k in places], (0, 0, 0)), owed, places)

    def test_what_is_inside(self):
        """A hull, or on the boundary of one. The order of the points does not matter."""
        octahedron = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
        tetrahedron = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
        for points, owed in [(octahedron, True), (octahedron[:5], False), (octahedron[:4], False),
                             (octahedron[:2], False), (tetrahedron, True)]:
            for some in itertools.permutations(points):
                self.assertEqual(judge.in_interior(some, (0, 0, 0)), owed, some)


class Json(unittest.TestCase):
    def unreadable(self, text, case=TRIANGLE):
        result = judged(case, text)
        self.assertEqual(result["outcome"], "unreadable", text[:200])
        self.assertTrue(result["message"] and "\n" not in result["message"])

    def test_records_of_all_kinds_of_nonsense(self):
        for record in ['[]', '{', '"x"', '5', '{"index": 2}', '{"contact": [0]}', '{"index": "2", "contact": [0]}',
                       '{"index": 2.0, "contact": [0]}', '{"index": 4, "contact": [0]}',
                       '{"index": -1, "contact": [0]}',
                       '{"index": [2, 1], "contact": [0]}', '{"index": [1, 1], "contact": [0]}',
                       '{"index": [1, 2, 3], "contact": [0]}', '{"index": true, "contact": [0]}',
                       '{"index": 0, "contact": []}', '{"index": 0, "contact": ["0"]}',
                       '{"index": 0, "contact": [0.0]}',
                       '{"index": 0, "contact": [-1]}', '{"index": 0, "contact": [3]}', '{"index": 0, "contact": 0}',
                       '{"index": 0, "contact": [2147483647]}', '{"index": 0, "contact": [0], "kind": "regular"}',
                       '{"index": [1, 2], "contact": [0], "kind": "critical"}',
                       '{"index": 0, "index": 0, "contact": [0]}',
                       '{"index": 0, "contact": [0], "x": {"a": 1, "a": 1}}', '{"index": 0, "contact": [0], "x": NaN}',
                       '{"index": 0, "contact": [0], "x": 1e400}', '{"index": 0, "contact": [0], "x": -1e400}',
                       '{"index": 0, "center": [0, 0]}', '{"index": 0, "center": [0, 0, 0, 0]}',
                       '{"index": 0, "center": [0, 0, null]}', '{"index": 0, "center": ["0", "0", "\u0660"]}',
                       '{"index": 0, "center": ["0", "0", "1/0"]}', '{"index": 0, "center_double": [0, null, 0]}',
                       '{"index": 0, "center": [0, 0, 0], "squared_distance": -1}',
                       '{"index": 0, "center": [0, 0, 0], "squared_distance": "-1/2"}',
                       '{"index": 0, "center": [0, 0, 0], "squared_distance_double": -0.5}',
                       '{"index": 0, "contact": [0], "volume": -1}', '{"index": 0, "contact": [0], "volume": "-1/8"}',
                       '{"index": 0, "contact": [0], "volume_double": -1}',
                       '{"index": 0, "contact": [0], "volume": "1/0"}',
                       '{"index": 2, "contact": [0], "shares": [[0, -1]]}',
                       '{"index": 2, "contact": [0], "shares": [[0]]}',
                       '{"index": 2, "contact": [0], "shares": [[9, 1]]}',
                       '{"index": 2, "contact": [0], "shares_double": [[9, null]]}',
                       '{"index": 2, "contact": [0], "shares": [], "shares_double": []}',
                       '{"index": 0, "contact": [0], "samples": [0, 1]}',
                       '{"index": 2, "contact": [0], "samples": [0, 1]}',
                       '{"index": 1, "contact": [0, 1], "limits": [null, null]}',
                       '{"index": 2, "contact": [0], "limits": [null]}',
                       '{"index": 2, "contact": [0], "limits": [null, 5]}',
                       '{"index": 2, "contact": [0], "limits": [null, [7]]}',
                       '{"index": 1, "contact": [0, 1], "samples": [7]}',
                       '{"index": 1, "contact": [0, 1], "stable": {}}', '{"index": 2, "contact": [0], "stable": []}',
                       '{"index": 2, "contact": [0], "stable": {"boundary": [0]}}',
                       '{"index": 2, "contact": [0], "stable": {"boundary": [[8]]}}',
                       '{"index": 2, "contact": [0], "stable": {"walk": [8]}}',
                       '{"index": 2, "contact": [0], "stable": {"walk": 8}}',
                       '{"index": [1, 2], "contact": [0], "stable": {"boundary": []}}',
                       '{"index": 1, "contact": [0, 1], "skeleton": {"segments": []}}',
                       '{"index": 2, "contact": [0], "skeleton": {}}',
                       '{"index": 2, "contact": [0], "lambda": {"directions": [], "arcs": [[7]]}}',
                       '{"index": 2, "contact": [0], "lambda": {"directions": [{"limit": [7]}], "arcs": []}}',
                       '{"index": 2, "contact": [0], "lambda": {"directions": [{}], "arcs": []}}',
                       '{"index": 2, "contact": [0], "lambda": {"directions": [{"limit": null, "exit": [0, 0, 0], '
                       '"vector": [1, 0, 0]}], "arcs": []}}',
                       '{"index": 2, "contact": [0], "lambda": {"directions": [{"limit": null, "vector": [0, 0, 0]}], '
                       '"arcs": []}}',
                       '{"index": 2, "contact": [0], "connections": [{"to": [7], "orbits": 1, "families": 0}]}',
                       '{"index": 2, "contact": [0], "u1": {}}',
                       '{"index": 1, "contact": [0], "u1": {"vertices": [], "traces": [], "runs": [], "segments": [], '
                       '"sheets": [{"samples": [0, 1], "corners": [[0, 0, 0]]}]}}',
                       '{"kind": "infinity"}', '{"kind": "infinity", "skeleton": {}}',
                       '{"kind": "infinity", "skeleton": {"segments": [{"samples": [0, 8], "front": [0, 0, 0], '
                       '"back": [0, 0, 0]}]}}']:
            self.unreadable(text_of(HEADER, record))

    def test_headers_of_all_kinds_of_nonsense(self):
        for head in ['{}', '{"format": "flowcert-stationary-points"}', '{"format_version": 1}',
                     '{"format": "flowcert-stationary-points", "format_version": "1"}',
                     '{"format": "flowcert-stationary-points", "format_version": 2}',
                     '{"format": "flowcert-stationary-points", "format_version": 1.0}',
                     '{"format": "flowcert-pockets", "format_version": 1}',
                     HEADER[:-1] + ', "points": "3"}', HEADER[:-1] + ', "points": 3.0}',
                     HEADER[:-1] + ', "points": -3}',
                     HEADER[:-1] + ', "points": 18446744073709551616}', HEADER[:-1] + ', "classes": [0]}',
                     HEADER[:-1] + ', "critical": [3, 3, 1]}', HEADER[:-1] + ', "critical": [3, 3, 1, "0"]}',
                     HEADER[:-1] + ', "regular_stationary": {"1-2": 0}}', HEADER[:-1] + ', "input_sha256": "00"}',
                     HEADER[:-1] + ', "indices": [0, 0]}', HEADER[:-1] + ', "indices": ["0"]}',
                     HEADER[:-1] + ', "indices": [4]}', HEADER[:-1] + ', "hull_volume": -1}',
                     HEADER[:-1] + ', "morse_smale": 1}', HEADER[:-1] + ', "volumes": "all"}', HEADER + HEADER]:
            self.unreadable(text_of(head, '{"index": 0, "contact": [0]}'))

    def test_what_may_be_there(self):
        def one(text):
            self.assertNotEqual(verdict(TRIANGLE, text_of(HEADER, text)), "unreadable", text)
        one('{"index": -0, "contact": [-0]}')
        one('{"index": 0, "contact": [0], "note": {"limit": "north", "samples": [77]}}')
        one('{"index": 0, "contact": [0], "note": ' + "[" * 15 + "]" * 15 + "}")
        one('{"index": 0, "contact": [0], ' + ", ".join(f'"k{k}": 0' for k in range(998)) + "}")
        one('{"index": 0, "center_double": [0, 0, 0], "contact": [0]}')
        one('{"index": 2, "contact": [0, 1, 2], "shares_double": [[0, null], [1, 0.5]], "volume_double": null}')
        one('{"index": 2, "contact": [0, 1, 2], "stable": {"walk": [0, 1, 0]}}')
        one('{"index": 2, "contact": [0, 1, 2], "stable": {"walk": null}}')
        one('{"index": 2, "contact": [0, 1, 2], "lambda": {"directions": [{"limit": null, "vector": [1, 0, 0]}], '
            '"arcs": []}}')
        one('{"index": 2, "contact": [0, 1, 2], "surface": {"vertices": [[0.5, 0, 9]], "triangles": []}}')
        one('{"kind": "infinity", "skeleton": {"segments": []}}')
        one('')
        self.assertNotEqual(verdict(TRIANGLE, text_of(HEADER[:-1] + ', "points": 18446744073709551615}')), "unreadable")

    def test_limits_of_json(self):
        self.unreadable(text_of(HEADER, '{"index": 0, "contact": [0], "note": ' + "[" * 16 + "]" * 16 + "}"))
        self.unreadable(text_of(HEADER, '{"index": 0, "contact": [0], "note": ' + "[" * 99999 + "]" * 99999 + "}"))
        self.unreadable(text_of(HEADER,
                                '{"index": 0, "contact": [0], ' + ", ".join(f'"k{k}": 0' for k in range(999)) + "}"))
        infinity = '{"kind": "infinity", "skeleton": {"segments": []}}'
        self.unreadable(text_of(HEADER, infinity, infinity))
        self.unreadable(text_of(HEADER).encode() + b'{"index": 0, "contact": [0], "note": "\xff"}')

    def test_ids_of_level_5_are_ids(self):
        segment = '{"samples": [0, %d], "front": [0, 0, 0], "back": [0, 0, 0], "%s": [%d]}'
        for samples, key, contact, is_read in [(1, "back_contact", 2, True), (8, "back_contact", 2, False),
                                               (1, "back_contact", 8, False), (1, "front_contact", 8, False)]:
            one = segment % (samples, key, contact)
            text = text_of(HEADER, '{"index": 2, "contact": [0, 1, 2], "skeleton": {"segments": [%s]}}' % one)
            self.assertEqual(verdict(TRIANGLE, text) != "unreadable", is_read, one)

    def test_lists_of_level_5_are_well_formed(self):
        for record, is_clean in [('{"index": 2, "contact": [0, 1, 2], "shares": [[0, 1], [0, 2]]}', False),
                                 ('{"index": 2, "contact": [0, 1, 2], "shares": [[0, 1], [1, 2]]}', True),
                                 ('{"index": 2, "contact": [0, 1, 2], "limits": [[], null]}', False),
                                 ('{"index": 2, "contact": [0, 1, 2], "lambda": {"directions": [], "arcs": [[0, 0]]}}',
                                  False),
                                 ('{"index": 1, "contact": [0, 1], "samples": [0, 0]}', False),
                                 ('{"index": 1, "contact": [0, 1], "samples": []}', True)]:
            found = reasons(TRIANGLE, text_of(HEADER, record))
            self.assertEqual((1, "malformed", 2) not in found, is_clean, record)


class Text(unittest.TestCase):
    RIGHT = ["0,0,0,0", "0,4,0,0", "0,1,3,0", "1,2,0,0", "1,0.5,1.5,0", "1,2.5,1.5,0", "2,2,1,0,5"]

    def test_ends_of_lines(self):
        for end in ["\n", "\r\n", "\r"]:
            self.assertEqual(verdict(TRIANGLE, end.join(self.RIGHT)), "conforms", repr(end))
            text = end.join([HEADER, '', ' \t', *[json.dumps(one) for one in right_records(TRIANGLE)]])
            self.assertEqual(verdict(TRIANGLE, text), "conforms", repr(end))
            self.assertEqual(verdict(TRIANGLE, end.join(["inf 3", "0 | 0", "1 | 0 |", "2|0"])), "fails", repr(end))
        found = reasons(TRIANGLE, "\r".join(["", *self.RIGHT, "3,9,9,9"]))
        self.assertEqual([one for one in found if one[0] == 2], [(2, "wrong-position", 9)])

    def test_byte_order_marks_are_passed_over(self):
        text = "\n".join(self.RIGHT)
        self.assertEqual(verdict(TRIANGLE, "\ufeff" + text), "conforms")
        self.assertEqual(verdict(TRIANGLE, gzip.compress(("\ufeff" + text).encode())), "conforms")
        self.assertEqual(verdict(TRIANGLE, "\ufeff" + text_of(HEADER, *right_records(TRIANGLE))), "conforms")
        self.assertEqual(verdict(TRIANGLE, "0,0,0,0\n\ufeff0,4,0,0"), "unreadable")
        self.assertEqual(verdict(TRIANGLE, "\ufeff\ufeff" + text), "unreadable")

    def test_empty_files_are_unreadable(self):
        for data in [b"", b"\n", b" \t\v\f\r\n", b"\xef\xbb\xbf", b"\xef\xbb\xbf\n", gzip.compress(b""),
                     gzip.compress(b"\n")]:
            self.assertEqual(verdict(TRIANGLE, data), "unreadable", data)
        for text in ["# nothing", "index,x,y,z", "inf 3", HEADER]:
            self.assertEqual(verdict(TRIANGLE, text), "fails", text)

    def test_damaged_gzip_is_unreadable(self):
        data = gzip.compress("\n".join(self.RIGHT).encode())
        self.assertEqual(verdict(TRIANGLE, data), "conforms")
        self.assertEqual(verdict(TRIANGLE, data + b"\0" * 9), "conforms")
        for damaged in [data[:-1], data[:12], data[:3], data + b"x", data[:20] + b"\xff\xff\xff" + data[23:],
                        data[:-6] + b"xx" + data[-4:], data[:2] + b"\x07" + data[3:]]:
            self.assertEqual(verdict(TRIANGLE, damaged), "unreadable", damaged)

    def test_what_grows_too_much_is_refused(self):
        self.assertEqual(verdict(TRIANGLE, gzip.compress(b"#" * (1 << 20))), "fails")
        self.assertEqual(verdict(TRIANGLE, gzip.compress(b"#" * ((1 << 20) + 1))), "unreadable")
        data = gzip.compress(b"#" * 2000000)
        for size, outcome in [(20000, "fails"), (19999, "unreadable")]:  # zeros may follow
            self.assertEqual(verdict(TRIANGLE, data.ljust(size, b"\0")), outcome)
        asked = []
        empty = SimpleNamespace(read=lambda most: asked.append(most) or b"")
        with unittest.mock.patch("gzip.GzipFile", lambda **_: empty):
            self.assertEqual(verdict(TRIANGLE, b"\x1f\x8b" + bytes(43 << 20)), "unreadable")
        self.assertEqual(asked, [(4 << 30) + 1])

    def test_columns_are_named_by_their_order(self):
        for names, is_read in [("index,x,y,z", True), ("index x y z", True), ("index,x,y,z,squared_distance", True),
                               ("index,x,y,z,squared_distance,contact", True), ("index,z,y,x", False), ("index", False),
                               ("index,x,y,z,", True), ("index,x,y,z,, # more", True), ("index,x,y,z,,contact", False),
                               ("index,x,,", False),
                               ("index,x,y", False), ("index,x,y,z,contact", False), ("Index,x,y,z", False)]:
            text = "\n".join(["# a comment", names, *self.RIGHT])
            self.assertEqual(verdict(TRIANGLE, text), "conforms" if is_read else "unreadable", names)
        self.assertEqual(verdict(TRIANGLE, "\n".join(["index,x,y,z", "index,x,y,z", *self.RIGHT])), "unreadable")
        self.assertEqual(verdict(TRIANGLE, "\n".join([*self.RIGHT, "index,x,y,z"])), "unreadable")

    def test_fields_of_csv(self):
        for line, is_read in [("2 2 1 0", True), ("2\v2\f1\t0", True), ("2 , 2 ,1, 0", True), ("2,2,1,0,", True),
                              ("2,2,1,0,,", True), ("2,2,1,0,5,0,1,2", True), ("2,2,1,0,,0,1,2", True),
                              ("2,,,,,0,1,2", True), ("2,,,,5,0,1,2,,", True), ("2,2,1,0 # it is", True),
                              ("2,2,1,0#", True),
                              (" 2,2,1,0 ", True), ("2,+2.,1e0,.0", True), ("2,2,1", False), ("2,2,1,", False),
                              ("2,,,", False),
                              ("2,,,,", False), ("2,2,1,0,-5", False), ("2,2,1,0,5,0,,1", False), (",2,2,1,0", False),
                              ("4,2,1,0", False), ("02,2,1,0", False), ("2,2,1,0,5,+1", False), ("2;2;1;0", False),
                              ("2,2,1.#INF,0", False), ("2,2,1.#,0", False), ("2,2,1,0,5,9", False),
                              ("2,2,1,\u0660", False),
                              ("2,2,1,0\u00a0", False), ("2,2,,0", False), (",,,,,", False),
                              ("2,2,,0,,0,1,2", False), ("2,2,,,,0,1,2", False), ("2,,1,,,0,1,2", False),
                              ("2,2,1,0,5,0.0", False)]:
            found = verdict(TRIANGLE, "\n".join([*self.RIGHT[:-1], line]))
            self.assertEqual(found, "conforms" if is_read else "unreadable", line)

    def test_lines_of_giesen_and_kuehne(self):
        right = ["inf 3", "0 | 0 | 0 1 | 0 2 |", "1 | 0 | 0 1 | 1 2", "2|0|0 2|1 2|", "0 1 | 2 | 0 1 2",
                 "0 2 | 1.5811388300841898 |"
                 " 0 1 2", "1 2 | 2.1213203435596424 | 0 1 2", "0 1 2 | 2.23606797749979 | inf |"]
        self.assertEqual(verdict(TRIANGLE, "\n".join(right)), "conforms")
        self.assertEqual(verdict(TRIANGLE, "\n".join(right[1:])), "conforms")
        for line, is_read in [("0 1 2 | 2.23606797749979", True), ("0 1 2 | -1", False), ("0 1 2", False),
                              ("| 2.2", False),
                              ("0 1 2 | ", False), ("0 1 2 | 2 2", False), ("0 1 2 0 1 | 2", False),
                              ("0 1 2 | 2 | | inf", False),
                              ("0 1 2 | 2 | 9 ", False), ("0 1 2 | 2 | inf 3", False), ("0 1 2 | 2 | 0 1 2 0 1", False),
                              ("inf 2", False), ("inf", False), ("inf 3 3", False), ("0 1 x | 2", False),
                              ("# no | 1", False)]:
            found = verdict(TRIANGLE, "\n".join([*right[1:-1], line]))
            self.assertEqual(found != "unreadable", is_read, line)
        self.assertEqual(verdict(TRIANGLE, "\n".join([*right, "inf 3"])), "unreadable")

    def test_comments_may_be_in_another_encoding(self):
        self.assertEqual(verdict(TRIANGLE, b"# \xff\n" + "\n".join(self.RIGHT).encode()), "conforms")

    def test_vtp_and_pockets_are_unreadable(self):
        self.assertEqual(judged(TRIANGLE, "<VTKFile>")["message"], "VTP is not read here")
        self.assertEqual(verdict(TRIANGLE, '\n {"format": "flowcert-pockets-1"}'), "unreadable")


class Verdicts(unittest.TestCase):
    def test_judgements_of_levels_1_to_4(self):
        judgements = json.loads((SPEC / "judgements.json").read_text())["judgements"]
        asked = [one for one in judgements if "answers" not in one and one.get("levels", 4) < 5]
        self.assertGreater(len(asked), 100)
        for one in asked:
            result = judged(CASES[one["case"]], text_of(*one["claim"]), highest_level=one.get("levels", 4))
            owed = one["verdict"], judgements_test.sorted_findings(one["findings"])
            self.assertEqual((result["outcome"], judgements_test.sorted_findings(result["findings"])), owed, one["id"])
            if "statement" in one:
                said = judge.statement(result["outcome"], [result["profile"]], 1e-9)
                self.assertEqual(said, one["statement"], one["id"])

    def test_what_both_judges_have_said(self):
        """These claims are of all kinds. `flowcert check` said the same of each, finding by finding."""
        claims = json.loads((Path(__file__).parent / "judged_claims.json").read_text())["claims"]
        self.assertGreater(len(claims), 100)
        for one in claims:
            result = judged(CASES[one["case"]], text_of(*one["claim"]))
            found = [[f[key] for key in ("level", "reason", "permitted", "clause", "line")] for f in result["findings"]]
            owed = one["outcome"], sorted(one["findings"], key=json.dumps)
            self.assertEqual((result["outcome"], sorted(found, key=json.dumps)), owed, one)
            said = sorted(result["judged"]), result["undecided"]
            self.assertEqual(said, (one["judged"], one["undecided"]), one)

    def test_one_triangle_at_an_edge_tells_the_angle_there(self):
        acute, right, obtuse = [True, False], [True, True], [False, True]
        for r, s, owed in [((0, 5, 0), (0, 3, 4), acute), ((0, 5, 0), (0, 0, 5), right), ((3, 4, 0), (3, 0, 4), right),
                           ((0, 5, 0), (0, -3, 4), obtuse)]:
            points = [[(one / 64).hex() for one in row] for row in ((5, 0, 0), (-5, 0, 0), r, s)]
            own = {"index": [1, 3], "contact": [0, 1, 2, 3], "center": ["0", "0", "0"], "squared_distance": "25/4096"}
            truth = judge.Truth({"points": points, "expected": {"stationary": [own]}})
            by_own = judge.Judge(truth, SimpleNamespace(points=[], indices={0, 1, 2, 3}), 0, 4)
            found = [by_own.is_possible(truth.records[0], *some) for some in ((1, 1, 0), (0, 1, 1))]
            self.assertEqual(found, owed, (r, s))

    def test_limits_without_sides_come_in_any_order(self):
        truth = judge.Truth(CASES["regular-stationary-points-0002"])
        regular = next(one for one in truth.records if not one.critical)
        maximum = SimpleNamespace(critical=True, index=3, hull=3)
        by_sides = judge.Judge(truth, None, 0, 4).may_be_limits
        for limits in ([None, maximum], [maximum, None]):
            self.assertTrue(by_sides(limits, [maximum, regular], False))
            self.assertEqual(by_sides(limits, [maximum, regular], True), limits[0] is maximum)
            self.assertTrue(by_sides([*limits, None, maximum], [maximum, regular], False))
            self.assertFalse(by_sides([limits[0], regular, limits[1]], [maximum, regular], False))

    def test_what_is_not_decided_is_said(self):
        head = HEADER[:-1] + ', "indices": [0, 1]}'
        for case in (TRIANGLE, CASES["cospherical-clusters-0001"], CASES["regular-stationary-points-0001"]):
            records = right_records(case)
            self.assertFalse(judged(case, text_of(HEADER, *records))["undecided"])
            few = [one for one in records if one["index"] in (0, 1)]
            self.assertEqual(verdict(case, text_of(head, *few)), "conforms")
            self.assertFalse(judged(case, text_of(head, *few))["undecided"])
        square = [{"index": 2, "contact": [0, 1, 2]}, {"index": 2, "contact": [0, 1, 3]},
                  {"index": 3, "contact": [0, 1, 2, 3]}]
        head = HEADER[:-1] + ', "indices": [2, 3]}'
        self.assertTrue(judged(CASES["cospherical-clusters-0001"], text_of(head, *square))["undecided"])
        right_angle = text_of(head, {"index": 2, "contact": [0, 1, 2]})
        result = judged(CASES["regular-stationary-points-0001"], right_angle)
        self.assertEqual((result["outcome"], result["undecided"]), ("perturbed", False))
        of_two = judge.Judge(None, None, 0, 4)
        for k, is_simplex in enumerate((False, True)):
            of_two.accept_perturbed(SimpleNamespace(k=k, is_simplex=is_simplex), [])
            self.assertTrue(of_two.undecided)

    def test_rounding_is_told_to_the_last_bit(self):
        """By 2^-44 of the larger of radius and coordinates: of 2.5 at the edge of rows 1 and 2, and of 8 at others."""
        head, one = HEADER[:-1] + ', "indices": [1]}', Fraction(1, 2**44)
        edges = [{"index": 1, "contact": one} for one in ([0, 1], [0, 2])]
        for off, owed in [(0, []), (one, ["rounding"]), (one * 1025 / 1024, ["wrong-position"])]:
            edge = {"index": 1, "contact": [1, 2], "center": [str(Fraction(5, 2) * (1 + off)), "3/2", "0"]}
            found = judged(TRIANGLE, text_of(head, *edges, edge))["findings"]
            self.assertEqual([one["reason"] for one in found], owed)
        for off, owed in [(23, "rounding"), (24, "wrong-position")]:  # 2.5 is 2.357 halves of the root of 9 / 2
            edge = {"index": 1, "contact": [1, 2], "squared_distance": str(Fraction(9, 2) * (1 + one * off / 10))}
            found = judged(TRIANGLE, text_of(head, *edges, edge))["findings"]
            self.assertEqual([one["reason"] for one in found], [owed])
        square = [(7, 0, 0), (8, 1, 0), (9, 0, 0), (8, -1, 0)]
        self.assertEqual(self.stray(square, [0, 1, 2]), "contact-incomplete")
        for near, reason in [(8 * one, "rounding"), (8 * one + Fraction(1, 2**50), "")]:
            self.assertEqual(self.stray([*square[:3], (8, -1 - near, 0)], [0, 1, 2, 3]), reason or "not-cospherical")
            self.assertEqual(self.stray([*square[:3:2], (8, 1 - near, 0)], [0, 1]), reason or "ball-not-empty")
            low = 1 - near + Fraction(1, 2**51)  # whose centre is a little farther from the long side
            self.assertEqual(self.stray([*square[:3:2], (8, low, 0)], [0, 1, 2]), reason or "outside-hull")

    def stray(self, rows, contact):
        """Why a contact set is that of no stationary point."""
        points = [[float(x).hex() for x in row] for row in rows]
        case = {"points": points, "expected": {"stationary": []}}
        claim = text_of(HEADER[:-1] + ', "indices": [2]}', {"index": 2, "contact": contact})
        return judged(case, claim)["findings"][0]["reason"]

    def test_the_tolerance_is_right_to_the_last_bit(self):
        head = HEADER[:-1] + ', "indices": [1]}'
        others = [{"index": 1, "contact": one} for one in ([0, 2], [1, 2])]
        for offset, outcome in [(Fraction(1, 2**19), "conforms"), (Fraction(2**40 + 1, 2**59), "fails")]:
            digits = str((2 + offset) * 10**60)
            edge = {"index": 1, "center": [f"{digits}e-60", "0.0", "0.0"], "contact": [0, 1]}
            self.assertEqual(verdict(TRIANGLE, text_of(head, edge, *others), tolerance=2.0**-20), outcome)
            root = 2 + offset
            edge = {"index": 1, "contact": [0, 1], "squared_distance": f"{root * root * 10**120}e-120"}
            self.assertEqual(verdict(TRIANGLE, text_of(head, edge, *others), tolerance=2.0**-20), outcome)

    def test_wrong_kinds_and_wrong_distances(self):
        case = CASES["regular-stationary-points-0001"]
        wrong = {"index": [2, 3], "contact": [0, 1, 2]}
        found = judged(case, text_of(HEADER, wrong))["findings"]
        self.assertIn(("wrong-index", "FC-CRIT-03"), [(one["reason"], one["clause"]) for one in found])
        case = CASES["critical-points-0060"]
        head = HEADER[:-1] + ', "indices": [1]}'
        far = {"index": 1, "center": [0.0, 0.0, 1e-11], "squared_distance": 2}
        found = [one for one in reasons(case, text_of(head, far, far)) if one[1] != "missing"]
        self.assertEqual(found, [(2, "ambiguous", 2), (2, "ambiguous", 3), (2, "wrong-position", 2),
                                 (2, "wrong-position", 3)])

    def test_right_claims_conform(self):
        right = [case for case in CASES.values() if case["result"] != "invalid" and len(case["points"]) < 9][::12]
        self.assertGreater(len(right), 60)
        for case in right:
            result = judged(case, text_of(header_of(case), *right_records(case)))
            self.assertEqual((result["outcome"], result["findings"]), ("conforms", []), case["id"])
            self.assertFalse(result["undecided"])
            self.assertLessEqual({1, 3}, result["judged"])

    def test_what_the_header_says(self):
        case = CASES["duplicates-0003"]
        head, records = header_of(case), right_records(case)
        for key, value, reason in [("points", 0, "wrong-counts"), ("merged_duplicates", 77, "wrong-counts"),
                                   ("critical", [0, 0, 0, 0], "wrong-counts"), ("classes", [], "malformed"),
                                   ("input_sha256", "0" * 64, "malformed"),
                                   ("regular_stationary", {"1-2": 9, "1-3": 0, "2-3": 0}, "wrong-counts")]:
            found = reasons(case, text_of({**head, key: value}, *records))
            self.assertEqual(found, [(1, reason, None)], key)
        edges, head_of_edges = [one for one in records if one["index"] == 1], {**head, "indices": [1]}
        for counts, outcome in [([9, len(edges), 9, 9], "conforms"), ([9, len(edges) + 1, 9, 9], "fails")]:
            self.assertEqual(verdict(case, text_of({**head_of_edges, "critical": counts}, *edges)), outcome)
        truth = judge.Truth(case)
        right = {**head, "classes": truth.classes, "input_sha256": truth.digest()}
        self.assertEqual(verdict(case, text_of(right, *records)), "conforms")
        zeros = [judge.Truth({"points": [[zero, "0x0p+0", "0x1p+0"]], "expected": {"stationary": []}}).digest()
                 for zero in ("0x0p+0", "-0x0p+0")]
        self.assertEqual(zeros[0], zeros[1])

    def test_findings_are_in_order(self):
        """What is not permitted comes first; then the levels, the lines and the contact sets tell it."""
        case = CASES["cospherical-clusters-0001"]
        head, square = HEADER[:-1] + ', "points": 5, "indices": [0, 2]}', {"index": 2, "contact": [0, 1, 2]}
        found = judged(case, text_of(head, square, {"index": 0, "contact": [1]}, {"index": 0, "contact": [3, 3]},
                                     {"index": 2, "contact": [1, 3]}, {"index": 0, "center": [9, 9, 9]}))["findings"]
        self.assertEqual([(one["level"], one["reason"], one["line"], one["contact"]) for one in found], [
            (1, "malformed", 4, [3, 3]), (1, "wrong-counts", None, []), (2, "wrong-position", 6, []),
            (3, "wrong-index", 5, [1, 3]), (3, "missing", None, [0]), (3, "missing", None, [2]),
            (3, "missing", None, [3]), (2, "spanning-part", 2, [0, 1, 2])])

    def test_profile_and_tolerance(self):
        records = right_records(TRIANGLE)
        near = [{"index": one["index"],
                 "center_double": [x + 1e-7 * x for x in one["center_double"]]} for one in records]
        for tolerance, outcome, said in [
                (1e-9, "fails", "does not conform to 1.2"),
                (1e-6, "conforms", "conforms to 1.2, points, approximate within 1e-06"), (2e-6, "conforms", None)]:
            result = judged(TRIANGLE, text_of(HEADER, *near), tolerance=tolerance)
            self.assertEqual(result["outcome"], outcome)
            self.assertEqual(judge.statement(outcome, [result["profile"]], tolerance), said)
        exact = judged(TRIANGLE, text_of(HEADER, *records), tolerance=1e-3)
        said = judge.statement("conforms", [exact["profile"]], 1e-3)
        self.assertEqual(said, "conforms to 1.2, points + U2 + S2, exact")
        few = text_of(HEADER[:-1] + ', "indices": [1, 2]}', *records[3:])
        said = judge.statement("conforms", [judged(TRIANGLE, few)["profile"]], 1e-9)
        self.assertEqual(said, "conforms to 1.2, points of index 1, 2, exact")
        case = CASES["regular-stationary-points-0002"]
        for key, told in [("none", (True, True)), ("limits", (False, True)), ("stable", (True, False))]:
            some = right_records(case)
            next(one for one in some if one["index"] == 2).pop(key, None)
            parts = judged(case, text_of(HEADER, *some))["profile"]["parts"]
            self.assertEqual(parts, {"points": True, "U2": told[0], "S2": told[1], "orbits": None}, key)
        for levels, said in [(1, None), (2, None), (3, "conforms to 1.2, points, exact")]:
            result = judged(TRIANGLE, text_of(HEADER, *records), highest_level=levels)
            self.assertEqual(judge.statement(result["outcome"], [result["profile"]], 1e-9), said)
            self.assertEqual(result["judged"], set(range(1, levels + 1)))

    def test_profiles_of_several_claims(self):
        one = {"parts": {"points": True, "U2": True, "S2": None, "orbits": None}, "indices": {0, 1, 2, 3},
               "exact": True}
        other = {"parts": {"points": True, "U2": False, "S2": True, "orbits": None}, "indices": {0, 1, 3},
                 "exact": False}
        self.assertEqual(judge.statement("perturbed", [one, other], 1e-9),
                         "is perturbed under 1.2, points of index 0, 1, 3 + S2, approximate within 1e-09")
        self.assertEqual(judge.statement("conforms", [one, one], 1e-9), "conforms to 1.2, points + U2, exact")
        parts = {"points": True, "U2": False, "S2": False, "orbits": None}
        some = [{"parts": parts, "indices": indices, "exact": True} for indices in ({0, 1}, {2, 3})]
        self.assertIsNone(judge.statement("conforms", some, 1e-9))
        orbits = {**some[0], "parts": {**parts, "points": False, "orbits": True}}
        self.assertEqual(judge.statement("conforms", [orbits], 1e-9), "conforms to 1.2, orbits, exact")
        self.assertIsNone(judge.statement("conforms", [], 1e-9))
        outcome = {"outcome": "conforms", "profile": one}
        for total, number in [(1, "1 vectors"), (2000, "1 of 2,000 vectors")]:
            said = judge.statement_of_all({"a": outcome}, SimpleNamespace(total=total), 1e-9)
            self.assertEqual(said, f"conforms to 1.2, points + U2, exact ({number})")
        self.assertEqual(judge.statement("fails", [], 1e-9), "does not conform to 1.2")


class Matching(unittest.TestCase):
    def test_as_many_as_possible_have_a_partner(self):
        for choices, size in [([[1, 2], [1], [2, 3]], 3), ([[1], [1]], 1), ([[1, 2], [2, 3], [1, 2]], 3), ([[]], 0),
                              ([], 0),
                              ([[1, 2, 3], [1, 2], [1]], 3), ([[1, 2], [1, 2], [1, 2]], 2),
                              ([[0, 1], [1, 2], [2, 3], [3, 4], [0]], 5)]:
            partner = judge.maximum_matching(choices)
            self.assertEqual(len(partner), size, choices)
            self.assertEqual(len(set(partner.values())), size)
            self.assertTrue(all(one in choices[k] for k, one in partner.items()))

    def test_a_free_partner_is_taken_first(self):
        self.assertEqual(judge.maximum_matching([[1, 2], [1], [2]]), {0: 1, 2: 2})

    def test_ranks(self):
        for index, hull, ranks in [(1, None, [0, 2, 1, 1, 2]), (2, None, [2, 0, 1, 1, 1]), (3, None, [2, 2, 2, 1, 1]),
                                   (1, 2, [2, 2, 0, 2, 2]), (1, 3, [2, 2, 2, 0, 2])]:
            point = SimpleNamespace(index=index, hull=hull)
            records = [SimpleNamespace(index=i, hull=j, critical=i == j)
                       for i, j in ((1, 1), (2, 2), (1, 2), (1, 3), (2, 3))]
            self.assertEqual([judge.Judge.rank(point, one) for one in records], ranks, (index, hull))

    # Stationary points on a line: index, dimension of the hull, place and squared distance. At the origin an index-1
    # point of the squared distance 4 is claimed. Each is meant instead of those before it, and, if it is free, of those
    # that are taken.
    MEANT = [(2, 2, 1, 4), (1, 2, 2, 9), (1, 1, 3, 9), (1, 1, 4, 4), (1, 1, 5, 16), (1, 2, 6, 4), (1, 1, 7, 4)]

    def meant(self, records, *claims):
        """The places of the stationary points that claims mean. A claim is an index, the dimension of a hull or None,
        and a squared distance, at the origin; or it names a stationary point, and has a fit."""
        truth = SimpleNamespace(records=[
            SimpleNamespace(k=k, index=index, hull=hull, critical=index == hull, center=(Fraction(x), 0, 0),
                            squared=Fraction(squared), allowed=100, rounding=0)
            for k, (index, hull, x, squared) in enumerate(records)])
        truth.placed = lambda names: (truth.records[names[0]], names[1]) if names else (None, None)
        points = [SimpleNamespace(index=index, hull=hull, names=name and (name[0], name[1]), line=1, contact=[],
                                  center=None if name else [(Fraction(0), False)] * 3, doubles=[], distance=None,
                                  squared=None if name else (Fraction(squared), True), squared_double="none")
                  for index, hull, squared, *name in claims]
        judge.Judge(truth, None, 1, 4).place(points)
        return [point.record.center[0] for point in points]

    def test_what_a_position_means(self):
        for count, twice in itertools.product(range(1, 8), (False, True)):
            records = self.MEANT[:count]
            if twice:  # the nearer one is meant
                records.append((*records[-1][:2], count + Fraction(1, 2), records[-1][3]))
            taken = [k for k in (2, 3, *([count] if count in (3, 4) else [])) if k < len(records)]
            claims = [*[(1, None, None, k, "whole") for k in taken], (1, None, 4)]
            self.assertEqual(self.meant(records, *claims)[-1], count, records)

    def test_a_position_does_not_mean_what_another_one_does(self):
        edges, regular = [(1, 1, 1, 9), (1, 1, 2, 9)], [(1, 2, 1, 4), (1, 2, 2, 4)]
        for records, claims, owed in [
                (edges, [(1, None, 4), (1, None, 4), (1, None, 4)], [1, 2, 1]),
                (edges, [(1, None, 9), (1, None, 4)], [1, 2]), (edges, [(1, None, 4), (1, None, 9)], [2, 1]),
                (edges, [(1, None, None, 0, "other"), (1, None, 9)], [1, 1]),
                (edges, [(3, None, None, 0, "whole"), (1, None, 9)], [1, 1]),
                (edges, [(1, None, None, 0, "part"), (1, None, 9)], [1, 2]),
                (regular, [(1, None, 4), (1, 2, 9), (1, 2, 9)], [1, 1, 2])]:
            self.assertEqual(self.meant(records, *claims), owed, claims)

    def test_a_position_means_what_no_contact_set_has_taken(self):
        case = CASES["critical-points-0060"]
        edge = {"index": 1, "center": [0.0, 0.0, 1e-11]}
        claims = [{"index": 1, "contact": one} for one in ([0, 1], [0, 2], [0, 3], [1, 2], [1, 3])]
        head = HEADER[:-1] + ', "indices": [1]}'
        for order in ([edge, *claims], [*claims, edge]):
            self.assertEqual(verdict(case, text_of(head, *order)), "conforms where determined")
        self.assertEqual(verdict(case, text_of(head, edge, edge, *claims[1:])), "conforms where determined")
        self.assertEqual(verdict(case, text_of(head, edge, edge, *claims)), "fails")
        # The distance tells them apart: 1 for {0, 1}, and 2^-66 less than 1 + 2^-66 for the other one.
        far = {**edge, "squared_distance": 2}
        self.assertEqual(verdict(case, text_of(head, far, *claims)), "fails")

    def test_what_is_one_of_several_is_not_judged_on_level_4(self):
        case = CASES["critical-points-0060"]
        head = HEADER[:-1] + ', "indices": [0, 1]}'
        edges = [{"index": 1, "contact": one} for one in ([0, 1], [0, 2], [0, 3], [1, 2], [1, 3])]
        samples = [{"index": 0, "contact": [k]} for k in range(4)]
        edge = {"index": 1, "center": [0.0, 0.0, 1e-11], "samples": [0, 2]}
        result = judged(case, text_of(head, *samples, *edges, edge))
        self.assertEqual((result["outcome"], 4 in result["judged"]), ("conforms where determined", False))
        edge = {"index": 1, "contact": [2, 3], "samples": [0, 2]}
        self.assertEqual(verdict(case, text_of(head, *samples, *edges, edge)), "fails")


class Perturbations(unittest.TestCase):
    PRISM = CASES["cospherical-clusters-0006"]

    def of_prism(self, indices, *contacts):
        head = HEADER[:-1] + f', "indices": {indices}}}'
        return text_of(head, *({"index": index, "contact": contact} for index, contact in contacts))

    def test_one_face_may_be_kept(self):
        for claims, outcome in [
                ([(3, [0, 1, 2, 4, 5])], "perturbed"), ([(3, [0, 1, 2, 3, 4, 5])], "conforms"),
                ([(3, [0, 1, 2, 4, 5]), (3, [0, 1, 2, 3, 4])], "fails"),
                ([(3, [0, 1, 2, 3, 4])], "perturbed"), ([(3, [0, 1, 2, 3])], "conforms where determined")]:
            self.assertEqual(verdict(self.PRISM, self.of_prism([3], *claims)), outcome, claims)


    def test_a_polygon_may_be_kept_beside_its_pyramid(self):
        case = CASES["regular-stationary-points-0019"]
        for claims, outcome in [([(2, [0, 1, 2, 3]), (3, [0, 1, 2, 3, 4])], "perturbed"),
                                ([(2, [0, 1, 2, 3])], "perturbed"), ([(2, [0, 1, 2, 4])], "fails")]:
            others = [(one["index"], one["contact"]) for one in right_records(case)
                      if one["index"] in (2, 3) and len(one["contact"]) < 5]
            self.assertEqual(verdict(case, self.of_prism([2, 3], *claims, *others)), outcome, claims)

    def test_polygons_at_an_edge(self):
        """One polygon of C(x) is kept, or, if C(x) can be an index-3 point that is not claimed, two."""
        rows = [(25, 0, 0), (-25, 0, 0), (7, 24, 0), (-7, 24, 0), (15, 20, 0), (7, 0, 24), (-7, 0, 24)]
        own = {"index": [1, 3], "contact": list(range(7)), "center": ["0", "0", "0"], "squared_distance": "625"}
        case = {"points": [[float(x).hex() for x in row] for row in rows], "expected": {"stationary": [own]}}
        one, other, triangle = (2, [0, 1, 2, 3, 4]), (2, [0, 1, 5, 6]), (2, [0, 1, 5])
        for indices, claims, outcome in [
                ([1, 2], [one, other], "perturbed"), ([1, 2, 3], [one, other, (3, [0, 1, 2, 3])], "fails"),
                ([1, 2, 3], [one, triangle, (3, [0, 1, 2, 3])], "perturbed"),
                ([1, 2, 3], [one, triangle, (3, [0, 1, 2, 3, 4, 5])], "perturbed"),
                ([1, 2, 3], [one, other, (3, [0, 1, 2, 3, 4, 5])], "fails"),
                ([1, 2, 3], [(2, [0, 1, 2, 3]), triangle, (3, [0, 1, 2, 5])], "fails")]:
            self.assertEqual(verdict(case, self.of_prism(indices, (1, [0, 1]), *claims)), outcome, claims)

    def test_what_is_made(self):
        by_claims = judge.Judge(None, None, 0, 4)
        by_claims.perturbed = {0: [SimpleNamespace(index=2, names=()), SimpleNamespace(index=1, names=(1, 2))]}
        for names, index, owed in [((1, 2), 1, True), ((0, 3), 1, False), ((0, 3), None, True), ((0, 3), 2, True)]:
            self.assertEqual(by_claims.is_made(SimpleNamespace(k=0), names, index), owed)
        self.assertFalse(by_claims.is_made(SimpleNamespace(k=1), (1, 2), 1))

    def test_incidences_with_other_indices_are_not_judged(self):
        edges = [{"index": 1, "contact": one, "samples": [0]} for one in ([0, 1], [0, 2], [1, 2])]
        result = judged(TRIANGLE, text_of(HEADER[:-1] + ', "indices": [1]}', *edges))
        self.assertEqual((result["outcome"], result["judged"]), ("conforms", {1, 2, 3}))

    def test_infinity_above_an_edge_without_saddles(self):
        case = CASES["critical-points-0055"]
        edge = next(one for one in case["expected"]["stationary"] if one["contact"] == [18, 26])
        line = f"18 26 | {nearest(edge['squared_distance']) ** 0.5!r} | inf"
        self.assertIn((4, "symbolic-perturbation", 1), reasons(case, line))
        self.assertNotIn(4, [level for level, *_ in reasons(case, line.replace("| inf", ""))])
        self.assertEqual([one[:2] for one in reasons(case, f"{line} | 0 1") if one[0] == 4],
                         [(4, "symbolic-perturbation"), (4, "wrong-incidence")])
        self.assertIn((4, "wrong-incidence", 1), reasons(case, line.replace("| inf", "| 0 1 | inf")))
        self.assertIn((4, "wrong-incidence", 5), reasons(TRIANGLE,
                                                         "\n".join(["", "0|0", "1|0", "2|0", "0 1 | 2 | inf"])))

    def test_boundaries_of_what_is_made_are_not_judged(self):
        case, head = CASES["cospherical-clusters-0001"], HEADER[:-1] + ', "indices": [1, 2]}'
        edges = [{"index": 1, "contact": one} for one in ([0, 1], [0, 2], [1, 3], [2, 3])]
        triangles = [{"index": 2, "contact": one, "stable": {"boundary": [[0, 1]]}} for one in ([0, 1, 2], [0, 1, 3])]
        result = judged(case, text_of(head, *edges, *triangles))
        self.assertEqual((result["outcome"], 4 in result["judged"]), ("perturbed", False))
        square = {"index": 2, "contact": [0, 1, 2, 3], "stable": {"boundary": [[0, 1]]}}
        self.assertEqual(verdict(case, text_of(head, *edges, square)), "fails")

    def test_limits_may_be_what_is_made(self):
        cube = CASES["cospherical-clusters-0002"]
        records = right_records(cube)
        whole = list(range(8))
        pyramid = {"index": 3, "contact": [0, 1, 2, 3, 7]}
        for named, outcome in [([0, 1, 2, 3, 7], "perturbed"), ([0, 1, 2, 3, 6], "fails"), (whole, "perturbed"),
                               ([0, 3, 5], "fails"), ([0, 1, 7], "fails"), (None, "fails")]:
            claims = [pyramid if one["contact"] == whole else json.loads(json.dumps(one)) for one in records]
            saddle = next(one for one in claims if one.get("limits") and whole in one["limits"])
            saddle["limits"] = [named if one == whole else one for one in saddle["limits"]]
            self.assertEqual(verdict(cube, text_of(HEADER, *claims)), outcome, named)

    def test_what_is_above_may_be_made(self):
        case = CASES["cospherical-clusters-0001"]
        samples = ["0 | 0 | 0 1 | 0 2", "1 | 0 | 0 1 | 1 3", "2 | 0 | 0 2 | 2 3", "3 | 0 | 1 3 | 2 3"]
        edges = ["0 1 | .5", "0 2 | .5", "1 3 | .5", "2 3 | .5"]
        made = ["0 1 2 | .70710678118654757", "0 1 3 | .70710678118654757", "0 1 2 3 | .70710678118654757"]
        found = reasons(case, "\n".join(samples + edges + made))
        self.assertEqual([one for one in found if one[0] == 4], [(4, "symbolic-perturbation", k) for k in (5, 6, 7, 8)])
        whole = ["0 1 2 | .70710678118654757 | inf"]
        up = [f"{edge} | 0 1 2" for edge in edges]
        self.assertEqual(verdict(case, "\n".join(samples + up + whole)), "conforms where determined")
        self.assertEqual(verdict(case, "\n".join([samples[0] + " | 0 3"] + samples[1:] + up + whole)), "fails")
        self.assertEqual(verdict(case, "\n".join([samples[0] + " | 1 3"] + samples[1:] + up + whole)), "fails")
        self.assertEqual(verdict(case, "\n".join(samples + edges + whole)), "fails")


    def boundary(self, edges, made=()):
        """What is found of a boundary that a tie leaves open, of a point of the squared distance 4. An edge is its
        names, an index, a squared distance, and whether it is critical. What is made has an index and names."""
        records = {names: SimpleNamespace(index=index, k=k, contact=names, squared=squared, critical=critical)
                   for k, (names, index, squared, critical) in enumerate(edges)}
        truth = SimpleNamespace(names=tuple, placed=lambda names: (records.get(names), "whole"))
        by_edges = judge.Judge(truth, None, 0, 4)
        by_edges.perturbed = {0: [SimpleNamespace(index=index, names=names) for index, names in made]}
        point = SimpleNamespace(line=1, contact=[], boundary=[one[0] for one in edges],
                                record=SimpleNamespace(squared=4, told={"boundary": None}))
        by_edges.check_boundary(point)
        return [(one["level"], one["reason"], one["permitted"]) for one in by_edges.findings]

    def test_boundaries_that_a_tie_leaves_open(self):
        first, *rest = (((0, 1), 1, 3, True), ((0, 2), 1, 3, True), ((1, 2), 1, 3, True))
        wrong, made = [(4, "wrong-incidence", False)], [(4, "symbolic-perturbation", True)]
        for other, owed in [(first, []), (((0, 1), 1, 4, True), wrong), (((0, 1), 1, 5, True), wrong),
                            (((0, 1), 2, 3, True), wrong), (((0, 1), 1, 3, False), made),
                            (((0, 3), 1, 3, True), wrong)]:
            self.assertEqual(self.boundary([other, *rest]), owed, other)
        for index, names, owed in [(1, (0, 1), made), (2, (0, 1), wrong), (1, (0, 2), wrong)]:
            self.assertEqual(self.boundary([((0, 1), 2, 3, True), *rest], [(index, names)]), owed, names)
        self.assertEqual(self.boundary([first, first]), wrong)
        self.assertEqual(self.boundary(rest), wrong)
        self.assertEqual(self.boundary([((0, 1, 2), 1, 3, True), ((1, 2, 3), 1, 3, True), ((0, 3), 1, 3, True)]), wrong)

    def test_where_an_orbit_may_end(self):
        regular = SimpleNamespace(critical=False, index=1, hull=2, squared=4)
        for index, hull, squared, owed in [(2, 2, 5, True), (3, 3, 5, True), (1, 1, 5, False), (2, 2, 4, False),
                                           (3, 3, 3, False)]:
            target = SimpleNamespace(critical=index == hull, index=index, hull=hull, squared=squared)
            self.assertEqual(judge.Judge(None, None, 0, 4).may_end(target, regular), owed, (index, squared))

    def test_infinity_where_no_direction_ends_there(self):
        """An edge without saddles above it, whose only direction is made to end at a maximum."""
        case = json.loads(json.dumps(CASES["critical-points-0055"]))
        told = case["expected"]["stationary"]
        edge, maximum = (next(one for one in told if one["contact"] == names) for names in (
            [18, 26], next(one["contact"] for one in told if one["index"] == 3)))
        edge["incidences"]["limits"] = [maximum["contact"]]
        line = f"18 26 | {nearest(edge['squared_distance']) ** 0.5!r} | inf"
        self.assertIn((4, "wrong-incidence", 1), reasons(case, line))


class Orbits(unittest.TestCase):
    """Claims about the orbit of one position."""

    def test_the_orbits_of_the_vectors_are_those_that_it_computes(self):
        cases = [case for case in CASES.values() if len(case.get("expected", {}).get("orbits", [])) > 3][::8]
        self.assertGreater(len(cases), 8)
        for case in cases:
            flow = judge.Flow(judge.Truth(case))
            for one in case["expected"]["orbits"]:
                true = judge.read_orbit(json.dumps(one).encode())
                computed = flow.orbit(tuple(map(Fraction, one["start"])))
                self.assertEqual([list(one) for one in computed[0]], [list(one) for one in true[0]], case["id"])
                self.assertEqual(computed[1], true[1], case["id"])
                self.assertEqual(flow.verdict(computed, true), "conforms")

    def beyond(self, name, start, way):
        """A case, the true orbit of a start, and that orbit with what follows its end in a direction."""
        case = CASES[name]
        flow = judge.Flow(judge.Truth(case))
        one = next(one for one in case["expected"]["orbits"] if one["start"] == start)
        segments, limit = judge.read_orbit(json.dumps(one).encode())
        first = flow.segment(limit[2], limit[2], tuple(map(Fraction, way)))
        more, end = flow.orbit(first[2]) if first[2] else ([], None)
        return flow, (segments, limit), ([*segments, first, *more], end)

    BEYOND = [("orbits-0004", ["1", "1", "0"], (0, 0, -1)), ("orbits-0004", ["1", "1", "0"], (1, 1, -1)),
              ("orbits-0006", ["0", "0", "1"], (0, -1, 0)), ("orbits-0010", ["1/2", "1/3", "0"], (0, 0, -1)),
              ("orbits-0017", ["1/8", "0", "1/8"], (0, 1, 0)), ("orbits-0017", ["1/8", "0", "1/8"], (1, 0, 1)),
              ("orbits-0018", ["0", "2/3", "4/3"], (-1, 1, 0)), ("orbits-0018", ["0", "2/3", "4/3"], (0, 1, 0)),
              ("orbits-0019", ["1", "3/2", "4/3"], (-1, 0, 0)), ("orbits-0024", ["7/3", "7/3", "5/3"], (0, 1, 1)),
              ("orbits-0046", ["17/6", "1/2", "1/3"], (1, 1, 1)), ("orbits-0074", ["0", "11/3", "11/3"], (0, -1, 0))]

    def test_an_orbit_may_go_on_beyond_a_regular_point(self):
        for one in self.BEYOND:
            flow, true, claimed = self.beyond(*one)
            self.assertEqual(flow.verdict(claimed, true), "perturbed", one)
            self.assertEqual(flow.verdict(true, true), "conforms")

    def test_what_comes_after_a_regular_point_is_judged(self):
        for one in self.BEYOND:
            flow, true, (segments, limit) = self.beyond(*one)
            count = len(true[0])

            def damaged(k, place, value):
                changed = [list(segment) for segment in segments]
                changed[k][place] = value
                return flow.verdict((changed, limit), true)

            for k, segment in enumerate(segments):
                last = k == len(segments) - 1
                y = segment[1]
                self.assertEqual(damaged(k, 0, "Q"), "fails", (one, k))
                self.assertEqual(damaged(k, 0, "C-C-C"), "fails", (one, k))
                self.assertEqual(damaged(k, 1, (y[0] + 1, *y[1:])), "fails", (one, k))
                self.assertEqual(damaged(k, 2, (y[0] + 7, *y[1:])), "fails", (one, k))
                if segment[2] is not None:
                    self.assertEqual(damaged(k, 2, None), "fails", (one, k))
                    half = tuple((a + b) / 2 for a, b in zip(segment[1], segment[2]))
                    self.assertEqual(damaged(k, 2, half), "fails", (one, k))
                self.assertEqual(damaged(k, 3, [99]), "fails", (one, k))
                if segment[2] is not None or k > count:
                    self.assertEqual(damaged(k, 4, [99]), "fails", (one, k))
                self.assertEqual(damaged(k, 5, [99]), "fails", (one, k))
                for place in (3, 4, 5):
                    self.assertEqual(damaged(k, place, None), "perturbed", (one, k))
                if not last:
                    self.assertEqual(flow.verdict((segments[:k + 1] + segments[k + 2:], limit), true), "fails",
                                     (one, k))
            self.assertEqual(flow.verdict((true[0][:-1], true[1]), true), "fails", one)
            (kind, driver, *rest), end = true[0][0], true[1]
            elsewhere = [kind, (driver[0] + 1, *driver[1:]), *rest]
            self.assertEqual(flow.verdict(([elsewhere, *true[0]], end), ([true[0][0], *true[0]], end)), "fails", one)
            self.assertEqual(flow.verdict((segments, true[1]), true), "fails", one)
            self.assertEqual(flow.verdict(([*segments, segments[-1]], limit), true), "fails", one)
            self.assertEqual(flow.verdict((segments[count:], limit), true), "fails", one)
            if limit is not None:
                for place, value in enumerate(["regular!", judge.Literal("1"), (9, 9, 9), [0, 1], Fraction(999)]):
                    changed = list(limit)
                    changed[place] = value
                    self.assertEqual(flow.verdict((segments, changed), true), "fails", (one, place))
                self.assertEqual(flow.verdict((segments, None), true), "fails", one)
            else:
                self.assertEqual(flow.verdict((segments, true[1]), true), "fails", one)

    def test_no_other_direction_leads_away(self):
        ways = [tuple(map(Fraction, way)) for way in itertools.product((-1, 0, 1), repeat=3) if any(way)]
        counts = Counter()
        for one in self.BEYOND[::2]:
            flow, true, _ = self.beyond(*one)
            y = true[1][2]
            for first in [flow.segment(y, y, way) for way in ways]:
                if first[2] is not None:
                    more, limit = flow.orbit(first[2])
                    leaves = judge.in_hull(flow.truth.where(first[4]), y)
                    found = flow.verdict(([*true[0], first, *more], limit), true)
                    self.assertEqual(found, "perturbed" if leaves else "fails", (one, first))
                    counts[found] += 1
        self.assertGreater(min(counts["perturbed"], counts["fails"]), 5)

    def test_a_segment_may_arrive_in_another_way(self):
        flow, (segments, limit), (longer, end) = self.beyond(*self.BEYOND[7])
        kind, driver, to, start, crossed, after = segments[-1]
        others = [one for one in judge.SEGMENT_TYPES if one[:4] == kind[:4]]
        self.assertGreater(len(others), 2)
        for one in others:
            for contact, is_part in [(after, True), (crossed, True), (crossed + after[-1:], True), (None, True),
                                     (after[:1], False), (crossed + [99], False)]:
                claimed = [*segments[:-1], [one, driver, to, start, crossed, contact]]
                is_true = one == kind and contact in (after, None)
                owed = "conforms" if is_true else "perturbed" if is_part and one[4:] != "inf" else "fails"
                self.assertEqual(flow.verdict((claimed, limit), (segments, limit)), owed, (one, contact))
                owed = "perturbed" if is_part and one[4:] != "inf" else "fails"
                found = flow.verdict((claimed + longer[len(segments):], end), (segments, limit))
                self.assertEqual(found, owed, (one, contact))

    def test_a_segment_arrives_from_where_it_comes(self):
        flow, (segments, limit), _ = self.beyond(*self.BEYOND[7])
        kind, *rest = segments[-1]
        others = [one for one in judge.SEGMENT_TYPES if one[:4] != kind[:4]]
        self.assertGreater(len(others), 9)
        for one in [*others, f"{kind[:4]}C", f"{kind[:4]}Q", f"{kind}-V"]:
            self.assertEqual(flow.verdict(([*segments[:-1], [one, *rest]], limit), (segments, limit)), "fails", one)

    def test_infinity_does_not_tell_the_direction(self):
        flow, true, (segments, limit) = self.beyond(*self.BEYOND[0])
        first = segments[-1]
        for kind, owed in [("E-E-inf", "perturbed"), ("E-F-inf", "perturbed"), ("V-E-inf", "fails"), ("E-E-V", "fails"),
                           ("F-F-inf", "fails"), ("E-C-inf", "fails")]:
            self.assertEqual(flow.verdict(([*segments[:-1], [kind, *first[1:]]], None), true), owed, kind)
        self.assertEqual(flow.verdict((segments, true[1]), true), "fails")

    def test_orbits_that_end_elsewhere_are_the_true_ones_alone(self):
        for case in [CASES[f"orbits-{k:04}"] for k in (1, 2, 3, 5)]:
            flow = judge.Flow(judge.Truth(case))
            for one in case["expected"]["orbits"]:
                segments, limit = judge.read_orbit(json.dumps(one).encode())
                self.assertEqual(flow.verdict((segments, limit), (segments, limit)), "conforms")
                if limit and limit[0] == "regular" or not segments:
                    continue
                self.assertEqual(flow.verdict((segments[:-1], limit), (segments, limit)), "fails")
                self.assertEqual(flow.verdict((segments + segments[-1:], limit), (segments, limit)), "fails")
                self.assertEqual(flow.verdict((segments, limit and [*limit[:4], 999]), (segments, limit)),
                                 "fails" if limit else "conforms")

    def test_orbits_are_read_by_their_format(self):
        right = json.dumps(CASES["orbits-0004"]["expected"]["orbits"][-1])
        self.assertEqual(judge.read_orbit(right.encode()), judge.read_orbit(b"\xef\xbb\xbf" + right.encode()))
        at = '{"segments": %s, "limit": %s}'
        limit = ('{"kind": "critical", "index": 0, "position": ["0", "-3/4", "0"], "contact": [1, 0], '
                 '"squared_distance": "0"}')
        segment = '{"type": "C-C-V", "driver": ["0", "0", "0"], "end": ["6/4", "0", "0"], "end_contact": [1, 0]}'
        read = judge.read_orbit((at % (f"[{segment}]", limit)).encode())
        self.assertEqual(read, ([["C-C-V", (0, 0, 0), (Fraction(3, 2), 0, 0), None, None, [0, 1]]],
                                ["critical", judge.Literal("0"), (0, Fraction(-3, 4), 0), [0, 1], 0]))
        self.assertEqual(judge.read_orbit((at % ("[]", '{"kind": "infinity"}')).encode()), ([], None))
        self.assertEqual(judge.read_orbit((at % ("[]", '{"\\ud83d\\ude00": 0, "kind": "infinity"}')).encode()),
                         ([], None))
        for text in ["", "[]", "{}", at % ("{}", limit), at % ("[5]", limit), at % ("[{}]", limit), at % ("[]", "null"),
                     at % ("[]", "{}"), at % ("[]", limit.replace("-3/4", "0.5")),
                     at % ("[]", limit.replace('"-3/4"', "5")),
                     at % ("[]", limit.replace("-3/4", "3/0")), at % ("[]", limit.replace("-3/4", "3/-4")),
                     at % ("[]", limit.replace("-3/4", "\u0663")), at % ("[]", limit.replace(', "0"]', "]")),
                     at % ("[]", limit.replace('"index": 0', '"index": 0.0')),
                     at % ("[]", limit.replace('"index": 0', '"index": 4')),
                     at % ("[]", limit.replace('"index": 0', '"index": "0"')),
                     at % ("[]", limit.replace('"index": 0', '"index": [1]')),
                     at % ("[]", limit.replace('"index": 0', '"index": [1, 2.0]')),
                     at % ("[]", limit.replace('"kind"', '"\\ud83d": 0, "kind"')),
                     at % ("[]", limit.replace("[1, 0]", "[1.0]")), at % ("[]", limit.replace('"-3/4"', "true")),
                     at % ("[%s]" % segment.replace('"C-C-V"', "5"), limit),
                     at % ("[%s]" % segment.replace("driver", "d"), limit),
                     at % ("[%s]" % segment.replace('["0", "0", "0"]', '"000"'), limit)]:
            with self.assertRaises(judge.Unreadable, msg=text):
                judge.read_orbit(text.encode())
        for data in (None, right.encode().replace(b'"segments"', b'"\xff": 0, "segments"')):
            with self.assertRaises(judge.Unreadable):
                judge.read_orbit(data)
        with self.assertRaisesRegex(judge.Unreadable, "there is no answer"):
            judge.read_orbit(None)
        with self.assertRaisesRegex(judge.Unreadable, "no rational in a string"):
            judge.read_orbit((at % ("[]", limit.replace('"-3/4"', "5"))).encode())
        with self.assertRaisesRegex(judge.Unreadable, "not a whole number: 1"):
            judge.read_orbit((at % ("[]", limit.replace("[1, 0]", '["1", 0]'))).encode())
        self.assertEqual(judge.read_orbit((at % ("[]", limit.replace("[1,", "[2147483646,"))).encode())[1][3],
                         [0, 2147483646])
        with self.assertRaises(judge.Unreadable):
            judge.read_orbit((at % ("[]", limit.replace("[1,", "[2147483647,"))).encode())


class Commands(unittest.TestCase):
    def run_one(self, command, text="0 0 0\n", seconds=20, start="1,0,0"):
        return judge.run_command(command, text, seconds, start)

    def test_how_commands_end(self):
        for status, outcome in [(0, 0), (1, 1), (2, 2), (125, 125), (126, "crashed"), (127, "crashed"), (128, 128),
                                (129, "crashed"), (134, "crashed"), (192, "crashed"), (193, 193), (254, 254),
                                (255, 255)]:
            self.assertEqual(self.run_one(f"exit {status}")[0], outcome, status)
        self.assertEqual(self.run_one("kill -9 $$")[0], "crashed")
        self.assertEqual(self.run_one("no-such-program")[0], "crashed")
        self.assertEqual(self.run_one("sleep 9", seconds=0.1)[0], "timed out")

    def test_what_commands_are_given_and_answer(self):
        self.assertEqual(self.run_one("cat {in}", "1 2 3\r\n"), (0, b"1 2 3\r\n", ""))
        self.assertEqual(self.run_one("cat {in} > {out}; echo no", "1 2 3\n")[1], b"1 2 3\n")
        self.assertEqual(self.run_one("printf %s {start}", start="1 2'3")[1], b"1 2'3")
        self.assertIsNone(self.run_one("true {out}")[1])
        self.assertEqual(self.run_one("cat")[1], b"")
        self.assertEqual(self.run_one("echo one >&2; echo two >&2; echo >&2; exit 3")[2], "exit status 3: two")
        self.assertEqual(self.run_one("exit 3")[2], "exit status 3")
        self.assertEqual(self.run_one("printf 'a\\033b' >&2; exit 3")[2], "exit status 3: a\\x1bb")
        self.assertEqual(len(self.run_one("printf %1000d 1 >&2; exit 3")[2]), len("exit status 3: ") + 160)
        long = "printf %0904d 0 >&2; printf '%4096d' 1 | tr ' ' B >&2; exit 3"  # the last 4,096 bytes are looked at
        self.assertEqual(self.run_one(long)[2], "exit status 3: " + "B" * 160)
        self.assertEqual(self.run_one("echo because >&2; sleep 9", seconds=0.1), ("timed out", b"", ""))
        self.assertEqual(len(self.run_one("head -c 16777216 /dev/zero")[1]), 16 << 20)
        self.assertIsNone(self.run_one("head -c 16777217 /dev/zero")[1])
        for size, is_read in [((1 << 20) - 2, True), ((1 << 20) - 1, False)]:
            answer = self.run_one(f"printf '\\037\\213'; head -c {size} /dev/zero")[1]
            self.assertEqual(answer is not None, is_read)
        self.assertEqual(self.run_one("head -c 70000000 /dev/zero > {out}")[:2], ("crashed", None))
        for size, status in [(3, 0), (5, 1)]:
            order = f"{sys.executable} -c 'bytearray({size} << 30)'"
            self.assertEqual(self.run_one(order)[0], status, size)

    def test_limits_of_commands(self):
        order = "import resource as r; print(r.getrlimit(r.RLIMIT_AS), r.getrlimit(r.RLIMIT_FSIZE))"
        self.assertEqual(self.run_one(f"{sys.executable} -c '{order}'")[1].decode(),
                         f"({4 << 30}, {4 << 30}) ({64 << 20}, {64 << 20})\n")

    def test_nothing_goes_on_after_a_command(self):
        process = Path("/proc", self.run_one("sleep 60 & echo $!")[1].decode().strip(), "stat")
        for _ in range(100):
            if not process.exists() or process.read_text().split()[2] == "Z":
                return
            time.sleep(0.05)
        self.fail("it still runs")

    def test_points_of_a_case(self):
        self.assertEqual(judge.points_text(TRIANGLE, False), "0.0 0.0 0.0\n4.0 0.0 0.0\n1.0 3.0 0.0\n")
        self.assertEqual(judge.points_text(TRIANGLE, True).split("\n")[1], "0x1p+2 0x0p+0 0x0p+0")
        self.assertEqual(judge.points_text({"points": []}, False), "# no points\n")
        self.assertEqual(judge.points_text({"text": "a\r"}, False), "a\r")
        self.assertEqual(judge.points_text({"points": [["nan", "0x1p", "0x1p+1"]]}, False), "nan 0x1p 2.0\n")


def run_main(*words):
    """The exit status of a run, and what it prints."""
    out, old = io.StringIO(), sys.argv
    sys.argv = ["judge.py", *map(str, words)]
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            try:
                status = judge.main()
            except SystemExit as end:
                status = end.code
    finally:
        sys.argv = old
    return status, out.getvalue()


class Runs(unittest.TestCase):
    def test_nothing_is_written_beside_judge_py(self):
        self.assertTrue(sys.dont_write_bytecode)

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="judge-test-")
        cls.claim = Path(cls.folder.name, "claim")
        chosen = {"critical-points": ["critical-points-0001", "critical-points-0002"], "orbits": ["orbits-0004"],
                  "invalid-input": [case for case in CASES if case.startswith("invalid-input")][::4]}
        cls.cases = [CASES[one] for ids in chosen.values() for one in ids]
        for name, ids in chosen.items():
            cases = [CASES[one] for one in ids]
            Path(cls.folder.name, f"{name}.json").write_text(json.dumps({"group": name, "cases": cases}))
        Path(cls.folder.name, "flags.json").write_text((SPEC / "vectors" / "flags.json").read_text())
        cls.right = Path(cls.folder.name, "right")
        cls.right.mkdir()
        for name in ("critical-points-0001", "critical-points-0002", "orbits-0004"):
            case = CASES[name]
            digest = judge.hashlib.sha256(judge.points_text(case, False).encode()).hexdigest()
            (cls.right / digest).write_text(text_of(header_of(case), *right_records(case)))
        cls.command = f"f={cls.right}/$(sha256sum < {{in}} | cut -c1-64); test -f $f && cat $f"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_judge(self, *words):
        return run_main("--vectors", self.folder.name, *words)

    def test_a_right_program_conforms(self):
        status, text = self.run_judge("--against", self.command, "--time-limit", 20)
        starts, total = sum(case.get("refused") == "start" for case in self.cases), len(self.cases)
        asked = total - starts
        self.assertEqual(status, 0, text)
        self.assertIn(f"\n{asked} cases: {asked} conform, 0 where determined, 0 perturbed, 0 negative\n", text)
        self.assertIn(f"skipped: {starts} cases\n", text)
        self.assertIn("judged: 3 claims on level 1, 3 claims on level 2, 3 claims on level 3, 3 claims on level 4\n",
                      text)
        self.assertTrue(text.endswith(f"conforms to 1.2, points + U2 + S2, exact ({asked} of {total} vectors)\n"), text)
        self.assertRegex(text, r"(?m)^  group critical-points: +2 conforms$")
        self.assertNotIn("not decided", text)
        self.assertTrue(text.startswith("  flag "), text)
        self.assertEqual(self.run_judge("--against", "exit 1")[0], 1)  # what is invalid is properly refused

    def test_a_wrong_program_does_not(self):
        status, text = self.run_judge("--against", "cat {in} >/dev/null; echo '# nothing'", "--most", 1)
        self.assertEqual(status, 1)
        self.assertIn("critical-points-0001", text)
        self.assertIn("level 3: missing [FC-CLAIM-03]: the contact set [0]", text)
        asked = sum(case.get("refused") != "start" for case in self.cases)
        self.assertIn(f"\nand {asked - 1} more\n", text)
        self.assertIn("does not conform to 1.2", text)
        self.assertEqual(text.count("level 3: "), 3)
        self.assertNotIn("more\n", self.run_judge("--against", "echo '# nothing'", "--most", asked)[1])

    def test_outcomes(self):
        case = ["--case", "critical-points-0002", "--json", "--against"]
        for command, outcome in [("exit 255", "refused"), ("echo [", "unreadable"), ("echo '# no'", "fails"),
                                 (self.command, "conforms"),
                                 ("true {out}", "unreadable")]:
            status, text = self.run_judge(*case, command)
            self.assertEqual(json.loads(text)["cases"][0]["outcome"], outcome, command)
            self.assertEqual(status, outcome != "conforms")
        case = ["--case", "invalid-input-0001", "--json", "--against"]
        probe = "case $(cat {in}) in '0 0 0'*) ;; *) %s;; esac"
        for command, outcome in [("exit 255", "properly refused"), ("exit 1", "properly refused"), ("echo", "accepted"),
                                 (probe % "exit 139", "crashed")]:
            status, text = self.run_judge(*case, command)
            self.assertEqual(json.loads(text)["cases"][0]["outcome"], outcome, command)
            self.assertEqual(status, outcome != "properly refused")
        told = json.loads(self.run_judge(*case, "exit 1")[1])
        self.assertEqual((told["format"], told["format_version"]), ("flowcert-judge", 1))
        status, text = self.run_judge("--case", "critical-points-0002", "--against", "echo because >&2; exit 3")
        self.assertIn("critical-points-0002 (an acute triangle): refused: exit status 3: because\n", text)

    def test_one_claim(self):
        self.claim.write_text("\n".join(Text.RIGHT))
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim)
        self.assertEqual(status, 0)
        self.assertIn("conforms to 1.2, points, approximate within 1e-09 (1 of ", text)
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim, "--tolerance", "1e-3")
        self.assertEqual(status, 0)
        self.assertTrue(text.endswith("no statement: the tolerance 0.001 is above 1e-06 (FC-CLAIM-23)\n"), text)
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim, "--tolerance", "1e-3",
                                      "--highest-level", 2)
        self.assertNotIn("statement", text)
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim, "--tolerance", "1e-6",
                                      "--highest-level", 4)
        self.assertIn("approximate within 1e-06 (1 of ", text)
        self.assertEqual(signal.getsignal(signal.SIGPIPE), signal.SIG_DFL)
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim, "--tolerance", "0")
        self.assertIn("approximate within 0.0 (1 of ", text)
        self.claim.write_text(text_of(HEADER[:-1] + ', "points": 4, "indices": [3]}'))
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim)
        self.assertIn("  level 1: wrong-counts [FC-IN-03]: the contact set of no point\n", text)
        self.claim.write_text("\n".join(Text.RIGHT[1:] + ["0,7,7,7"]))
        status, text = self.run_judge("--case", "critical-points-0002", "--claim", self.claim, "--tolerance", "1e-3")
        self.assertEqual(status, 1)
        self.assertIn("  level 2: wrong-position [FC-CRIT-01]: line 7\n", text)
        self.assertTrue(text.endswith("does not conform to 1.2 (1 of 14 vectors)\n"), text)

    def test_what_is_not_decided_is_printed(self):
        self.claim.write_text(text_of(HEADER[:-1] + ', "indices": [3]}', {"index": 3, "contact": [0, 1, 2, 3]}))
        status, text = run_main("--case", "cospherical-clusters-0001", "--claim", self.claim)
        self.assertEqual(status, 0)
        self.assertRegex(text, r"(?m)^judged: 1 claims on level 1, .*, 0 claims on level 4\nnot decided: 1 cases\n"
                         r"\n1 cases: 0 conform, 0 where determined, 1 perturbed, 0 negative\nis perturbed under 1.2")

    def test_what_is_not_said_otherwise(self):
        options = judge.parser_of_options().parse_args([])
        self.assertEqual(vars(options), {
            "against": None, "orbits_against": None, "claim": None, "vectors": str(judge.HERE / "vectors"), "group": [],
            "flag": [], "case": [], "tolerance": 1e-9, "highest_level": 4, "time_limit": 10, "most": 10, "hex": False,
            "json": False})

    def test_what_cannot_be_used(self):
        self.claim.write_text("\n".join(Text.RIGHT))
        for words in [[], ["--against", "true", "--claim", self.claim], ["--against", "true", "--tolerance", "0.0011"],
                      ["--against", "true", "--tolerance", "-1"], ["--against", "true", "--highest-level", "5"],
                      ["--claim", self.claim],
                      ["--group", "none", "--against", "true"],
                      ["--case", "invalid-input-0001", "--claim", self.claim], ["--against", "no-such-program"],
                      ["--against", "true", "--orbits-against", "true"],
                      ["--against", "true", "--orbits-against", "exit 127 {start}"],
                      ["--case", "critical-points-0002", "--claim", self.claim, "--orbits-against", "true {start}"],
                      ["--case", "critical-points-0002", "--claim", "/no/such/file"],
                      ["--against", "true", "--vectors", "/no/such"]]:
            status, text = self.run_judge(*words)
            self.assertEqual(status, 2, (words, text))
            self.assertIn("error: ", text)

    def test_groups_flags_and_cases_are_chosen(self):
        for words, count in [(["--group", "critical-points"], 2), (["--case", "orbits-0004"], 1),
                             (["--flag", "not-finite"], 3),
                             (["--group", "critical-points", "--case", "critical-points-0002"], 1)]:
            found = json.loads(self.run_judge(*words, "--json", "--against", "exit 1")[1])["cases"]
            owed = count if "--flag" not in words else sum("not-finite" in one["flags"] for one in self.cases)
            self.assertEqual(len(found), owed, words)

    def test_orbits_are_asked_for(self):
        orbits = CASES["orbits-0004"]["expected"]["orbits"]
        answers = Path(self.folder.name, "answers")
        answers.mkdir(exist_ok=True)
        for one in orbits:
            Path(answers, ",".join(one["start"]).replace("/", "_")).write_text(json.dumps(one))
        right = f"cat {answers}/$(echo {{start}} | tr / _) 2>/dev/null || test {{start}} = 1,0,0"
        words = ["--case", "orbits-0004", "--against", self.command, "--orbits-against"]
        status, text = self.run_judge(*words, right)
        self.assertEqual(status, 0, text)
        self.assertIn(f"judged: {len(orbits)} orbits\n", text)
        self.assertIn("conforms to 1.2, points + orbits, exact (1 of ", text)
        for command, outcome in [("echo {start}", "unreadable"), ("exit 4 || {start}", "refused"),
                                 ("test {start} = 1,0,0 || exit 139", "crashed"),
                                 ('echo {start} >/dev/null; echo \'{"segments": [], "limit": {"kind": "infinity"}}\'',
                                  "fails")]:
            status, text = self.run_judge(*words, command, "--json")
            found = json.loads(text)
            self.assertEqual((status, found["cases"][0]["outcome"]), (1, outcome), command)
            self.assertEqual(found["statement"], "does not conform to 1.2 (1 of 14 vectors)")
        flow, true, (segments, _) = Orbits().beyond(*Orbits.BEYOND[0])
        start = ",".join(Orbits.BEYOND[0][1])
        index = next(k for k, one in enumerate(orbits) if ",".join(one["start"]) == start)
        longer = json.loads(json.dumps(orbits[index]))
        last = {"type": "E-E-inf", "driver": longer["limit"]["position"], "end": None}
        longer.update(segments=[*longer["segments"], last], limit={"kind": "infinity"})
        Path(answers, start.replace("/", "_")).write_text(json.dumps(longer))
        status, text = self.run_judge(*words, right, "--json")
        one = json.loads(text)["cases"][0]
        self.assertEqual((status, one["outcome"], one["message"]), (0, "perturbed", f"another orbit from {start}"))
        self.assertEqual([orbit["outcome"] for orbit in one["orbits"]].count("perturbed"), 1)
        for command in (right, "exit 4 || {start}"):  # the first negative outcome stays
            status, text = self.run_judge(*words[:3], "echo '# nothing'", words[4], command, "--json")
            self.assertEqual(json.loads(text)["cases"][0]["outcome"], "fails")
        starts = [case for case in CASES.values() if case.get("refused") == "start"]
        status, text = self.run_judge("--case", starts[0]["id"], "--against", "true", "--orbits-against",
                                      "exit 1 # {start}", "--json")
        self.assertEqual(json.loads(text)["cases"][0]["outcome"], "properly refused")


def load_tests(loader, *_):
    """In the order of the file: what starts no program comes first."""
    return unittest.TestSuite(map(loader.loadTestsFromTestCase, (
        Numbers, Geometry, Json, Text, Verdicts, Matching, Perturbations, Orbits, Runs, Commands)))


if __name__ == "__main__":
    unittest.main()
