"""flowcert.check: the report is that of `flowcert check`, and Python lists and arrays are claims, too."""

import io
import json
import pathlib
from fractions import Fraction

import flowcert
import numpy as np
import pytest
from conftest import CUBE, flowcert_says
from flowcert import _judge

SCHEMA = pathlib.Path(__file__).parents[2] / "spec" / "schemas" / "exchange.schema.json"

TRIANGLE = np.array([[0, 0, 0], [6, 0, 0], [2, 4, 0]], dtype=float)


def listed(fc, exact=True):
    """All stationary points as a claim."""
    claim = []
    for i, point in enumerate(fc.stationary_points):
        position, squared_distance = fc.exact(i)
        claim.append(
            {
                "index": point["kind"] if point["index"] < 0 else point["index"],
                "contact": fc.contacts[slice(*point["contact_offsets"])],
                "center": position if exact else point["center"],
                "squared_distance": squared_distance if exact else point["squared_distance"],
            }
        )
    return claim


def wrong_claims(path):
    """Claims of the triangle with something wrong each, as files."""
    right = flowcert_says("compute", path, "-o", "-", "--manifolds", "u2").splitlines()
    yield "right", right
    yield "missing", right[:-1]
    yield "twice", [*right, right[-1]]
    yield "header", [right[0].replace('"points":3', '"points":4'), *right[1:]]
    yield "index", [line.replace('"index":1', '"index":0').replace('"samples"', '"colour"') for line in right]
    yield "position", [line.replace('"center":["3"', '"center":["31/10"') for line in right]
    yield "decimals", ["0 0 0 0 0 0", "0 6 0 0 0 1", "0 2 4 0 0 2", "1 3 0 0.000000001", "2 3 1 0 9.99"]


@pytest.mark.parametrize(
    "options", [{}, {"highest_level": 2}, {"indices": [1, 2]}, {"tolerance": 1e-6}, {"tolerance": 1e-3}], ids=str
)
def test_reports_are_those_of_the_program(options, xyz, tmp_path):
    words = []
    for name, value in options.items():
        words += ["--" + name.replace("_", "-"), ",".join(map(str, value)) if isinstance(value, list) else str(value)]
    verdicts = set()
    for name, lines in wrong_claims(xyz(TRIANGLE)):
        path = tmp_path / "claim.txt"
        path.write_text("\n".join(lines) + "\n")
        expected = json.loads(flowcert_says("check", xyz(TRIANGLE), path, "--json", *words))
        report = flowcert.check(TRIANGLE, path, **options)
        assert report.verdict == expected["verdict"], name
        assert report.is_exact == (expected["grade"] == "exact")
        assert report.statement == expected["profile"]["statement"], name
        assert list(report.claimed_counts) == expected["claimed"] and list(report.true_counts) == expected["critical"]
        levels = {int(level): fields["conforms"] for level, fields in expected["levels"].items()}
        assert report.levels == levels
        assert list(report.not_judged) == expected["not_judged"]
        assert list(report.not_decided) == expected["not_decided"]
        assert len(report.findings) == len(expected["findings"])
        for finding, fields in zip(report.findings, expected["findings"]):
            fields["contact"] = tuple(fields["contact"])
            assert {key: getattr(finding, key) for key in fields} == fields and finding.record is None
        assert report.fails == (report.verdict == "fails")
        verdicts.add(report.verdict)
    assert {"conforms", "fails"} <= verdicts


def test_statements_of_decimals_name_the_tolerance():
    points, claim = [[0, 0, 0], [2, 0, 0]], [{"index": 0, "contact": [0]}, {"index": 0, "contact": [1]}]
    near, exact = [*claim, {"index": 1, "center": [1.0, 0, 0]}], [*claim, {"index": 1, "center": [1, 0, 0]}]
    assert flowcert.check(points, near).statement == "conforms to 1.2, points, approximate within 1e-09"
    assert flowcert.check(points, near, tolerance=1e-6).statement == "conforms to 1.2, points, approximate within 1e-06"
    for tolerance in (1.0000000000000002e-6, 1e-3):
        report = flowcert.check(points, near, tolerance=tolerance)
        assert report.verdict == "conforms" and report.statement is None
    assert flowcert.check(points, exact, tolerance=1e-3).statement == "conforms to 1.2, points, exact"
    assert flowcert.check(points, claim, tolerance=1e-3).statement == "does not conform to 1.2"


def test_files_open_files_and_their_content(xyz, tmp_path):
    path = tmp_path / "claim.jsonl"
    text = flowcert_says("compute", xyz(CUBE), "-o", "-")
    path.write_text(text)
    with open(path) as opened, open(path, "rb") as opened_binary:
        content = text.encode()
        for claim in (path, str(path), content, bytearray(content), io.StringIO(text), opened, opened_binary):
            report = flowcert.check(CUBE, claim)
            assert report.verdict == "conforms" and report.is_exact


def test_lists_of_dicts():
    for points in (CUBE, TRIANGLE, flowcert.generate("right-angle-13", 3)):
        fc = flowcert.FlowComplex(points)
        exact = fc.check(listed(fc))
        assert exact.verdict == "conforms" and exact.is_exact, str(exact)
        decimals = flowcert.check(points, listed(fc, exact=False))
        assert not decimals.fails and not decimals.is_exact, str(decimals)
        assert exact.claimed_counts == exact.true_counts == fc.counts
    assert str(exact) == "conforms (exact)"


@pytest.mark.parametrize(
    "options, highest",
    [("", 3), ("--centers double", 3), ("--manifolds u2", 4), ("--manifolds all --skeletons --volumes exact", 5)],
)
def test_parsed_records_of_a_file_are_a_list_of_dicts(options, highest, xyz):
    for points in (TRIANGLE, CUBE):
        text = flowcert_says("compute", xyz(points), "-o", "-", *options.split())
        report = flowcert.check(points, [json.loads(line) for line in text.splitlines()[1:]])
        assert report.verdict == "conforms" and report.is_exact == ("double" not in options), str(report)
        assert report.not_judged == () and report.levels == {level: level <= highest or None for level in range(1, 6)}


def test_keys_of_records_are_those_of_the_schema():
    record = json.loads(SCHEMA.read_text())["definitions"]["record"]
    assert sorted(_judge._KEYS) == sorted(record["properties"])


def test_structured_arrays():
    fc = flowcert.FlowComplex(flowcert.generate("right-angles", 2))
    assert not fc.check(fc.stationary_points).fails
    assert "missing" in {finding.reason for finding in fc.check(fc.critical_points[1:]).findings}
    own = np.zeros(2, dtype=[("index", int), ("center", "f4", 3), ("label", "U8")])
    own["center"][1] = [2, 0, 0]
    assert fc.check(np.array(fc.critical_points[0]), indices=[3]).claimed_counts == (1, 0, 0, 0)
    assert fc.check(fc.critical_points[0], indices=[3]).claimed_counts == (1, 0, 0, 0)
    report = flowcert.check([[0, 0, 0], [2, 0, 0]], own)
    assert {finding.reason for finding in report.findings} == {"wrong-counts", "missing"}
    assert flowcert.check([[0, 0, 0], [2, 0, 0]], own, indices=[0]).verdict == "conforms"


def test_findings_say_which_record():
    claim = listed(flowcert.FlowComplex(TRIANGLE))
    claim[4]["center"] = (3, Fraction(1, 10**6), 0)
    report = flowcert.check(TRIANGLE, claim)
    assert report.fails
    (finding,) = report.findings
    assert (finding.record, finding.line, finding.reason) == (4, None, "wrong-position")
    assert str(finding).startswith("claim[4]: wrong, level 2: wrong-position [")
    assert str(report) == f"{finding}\nfails (exact)"
    missing = flowcert.check(TRIANGLE, claim[:-1]).findings[-1]
    assert (missing.record, missing.reason) == (None, "missing") and str(missing).startswith("claim: wrong, ")


def test_incidences_are_claims():
    claim = [
        {"index": 0, "contact": {0}},
        {"index": 0, "contact": range(1, 2)},
        {"index": 0, "contact": (2,)},
        {"index": 1, "contact": [0, 1], "samples": [0, 1]},
        {"index": 1, "contact": [0, 2], "samples": [0, 2]},
        {"index": 1, "contact": [1, 2], "samples": [1, 2]},
        {"index": 2, "contact": [0, 1, 2], "limits": [None, None]},
    ]
    assert flowcert.check(TRIANGLE, claim).levels == {1: True, 2: True, 3: True, 4: True, 5: None}
    claim[4]["samples"] = [0, 1]
    report = flowcert.check(TRIANGLE, claim)
    assert report.fails and report.findings[0].record == 4


def test_numbers_of_more_digits_than_python_prints():
    claim = [{"index": 0, "center": (Fraction(1, 3**10_000), 0, 0)}, {"index": 0, "contact": [1]}]
    report = flowcert.check([[0, 0, 0], [0, 1, 0]], claim, indices=[0])
    assert report.fails and report.findings[0].record == 0


@pytest.mark.parametrize(
    "claim, message",
    [
        (3, "claim must be a list of dicts, a structured array, the name of a file, or its content"),
        ({"index": 0}, "claim must be a list of dicts, a structured array, the name of a file, or its content"),
        (np.zeros((2, 3)), "claim must be a list of dicts, a structured array, the name of a file, or its content"),
        ([1], "claim[0] must be a dict"),
        ([{"index": 0, "contact": [0]}, {"position": 1}], "claim[1] has the key 'position'; the keys are index, "),
        ([{"index": 0, "contact": [0], "kind": {0}}], "claim[0]: Object of type set is not JSON serializable"),
        ([{"index": 0, "center": ["a", 0, 0]}], "claim[0]: "),
        ([{"index": 0, "center": [0, 0, float("nan")]}], "claim[0]: center, squared_distance and volume must be "),
        ([{"index": 0.5, "contact": [0]}], "claim[0]: an index or a row must be an integer, not 0.5"),
        ([{"index": 0, "contact": [0]}, {"index": 4, "contact": [0]}], "claim[1]: "),
        ([{"index": 0, "contact": [3]}], "claim[0]: there is no point 3; the ids are 0 to 2"),
        ([{"index": 0}], "claim[0]: "),
        ([{"index": 0, "center": [0, 0]}], "claim[0]: "),
        ([{"index": 0, "center": [np.longdouble("1e4000"), 0, 0]}], "claim[0]: center, squared_distance and "),
        (b"0 0 0\n", "claim:1: "),
        (b"\xff\xfe\n", r"claim:1: not an index, 0 to 3: '\xff\xfe'"),
        (b"{\n", "claim:1: "),
        ("no-such-file", "no-such-file"),
        ("no-such-caf\udce9", "no-such-caf\ufffd: cannot open"),
        ("bad\0file", r"'bad\x00file' is no name of a file"),
    ],
)
def test_what_is_no_claim_is_refused(claim, message):
    with pytest.raises(ValueError) as refused:
        flowcert.check(TRIANGLE, claim)
    assert str(refused.value).startswith(message) and "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "name, values, message",
    [
        ("tolerance", [-1, 0.1, float("nan"), 10**400, None, [1], "a"], "tolerance must be from 0 to 0.001"),
        ("highest_level", [0, 6, 10**20, 2.9, None, "2"], "highest_level must be an integer from 1 to 5"),
        ("indices", [[4], [-1], [10**20], [1.5], [None], 5, None, "12"], "indices must be integers from 0 to 3"),
        ("threads", [0, -5, 1025], "threads must be from 1 to 1024"),
    ],
)
def test_options_out_of_range_are_refused(name, values, message):
    for value in values:
        with pytest.raises(ValueError) as refused:
            flowcert.check(TRIANGLE, [], **{name: value})
        assert str(refused.value) == message


def test_a_complex_has_its_own_threads():
    fc = flowcert.FlowComplex(TRIANGLE)
    for threads in (1, -5):
        with pytest.raises(ValueError, match="^threads must be given to the FlowComplex"):
            fc.check([], threads=threads)
