"""What the package answers is what the program prints, to the bit: on inputs of every family, cubes and a scan."""

import json
import math
import struct
from collections import Counter
from decimal import Decimal
from fractions import Fraction

import flowcert
import numpy as np
import pytest
from conftest import CUBE, flowcert_says, json_lines, sphere_sample

# A regular stationary point of each kind, and points of every index.
RIGHT_ANGLES = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 1, 5]], dtype=float)
INPUTS = {
    "cube": CUBE,
    "right-angles": RIGHT_ANGLES,
    "two-points": RIGHT_ANGLES[:2],
    "repeated": np.concatenate([CUBE, CUBE[:3]]),
    "scan": sphere_sample(400),
    **{name: flowcert.generate(name, seed=6, level=2) for name in flowcert.families()},
}
assert all(len(points) for points in INPUTS.values())  # the program reads no empty file


@pytest.fixture(params=INPUTS, ids=str)
def points(request):
    return INPUTS[request.param]


def ratios(texts):
    return tuple(map(Fraction, texts))


def nearest(double, exact):
    """What JSON has as null is infinite here."""
    return double if double is not None else math.inf if exact > 0 else -math.inf


def records_of(path, *options):
    header, *records = json_lines(flowcert_says("compute", path, "-o", "-", *options))
    return header, records


def test_stationary_points(points, xyz):
    fc = flowcert.FlowComplex(points)
    header, records = records_of(xyz(points))
    assert header["points"] == len(points) and header["merged_duplicates"] == fc.merged_duplicates
    assert header["critical"] == list(fc.counts)
    assert header["regular_stationary"] == {f"{face}-{hull}": n for (face, hull), n in fc.regular_counts.items()}
    assert len(records) == len(fc.stationary_points) == len(fc.critical_points) + len(fc.regular_points)
    for i, (record, point) in enumerate(zip(records, fc.stationary_points)):
        is_regular = record["kind"] == "regular"
        assert point["index"] == (-1 if is_regular else record["index"])
        assert point["kind"].tolist() == (record["index"] if is_regular else [record["index"]] * 2)
        assert fc.contacts[slice(*point["contact_offsets"])].tolist() == record["contact"]
        position, squared_distance = fc.exact(i)
        assert (position, squared_distance) == (ratios(record["center"]), Fraction(record["squared_distance"]))
        assert point["center"].tolist() == list(map(nearest, record["center_double"], position))
        assert point["squared_distance"] == nearest(record["squared_distance_double"], squared_distance)
    assert (fc.regular_points["index"] == -1).all() and (fc.critical_points["index"] >= 0).all()
    assert fc.stationary_points["contact_offsets"].ravel().tolist()[-1:] == [len(fc.contacts)][: len(records)]


@pytest.mark.parametrize("zero", [False, True])
def test_persistence(points, xyz, zero):
    fc = flowcert.FlowComplex(points)
    options = ["--zero"] if zero else []
    if np.isinf(fc.stationary_points["squared_distance"]).any():
        words = "a squared distance is beyond the largest double"
        with pytest.raises(ValueError, match=f"^{words}"):
            fc.persistence(zero=zero)
        with pytest.raises(AssertionError, match=words):  # the exit status is 2
            flowcert_says("persistence", xyz(points), "-o", "-")
        return
    text = flowcert_says("persistence", xyz(points), "-o", "-", *options)
    lines = [line.split() for line in text.splitlines() if not line.startswith("#")]
    expected = [(int(dimension), (float(birth), float(death))) for dimension, birth, death in lines]
    assert fc.persistence(zero=zero) == expected
    pairs = fc.persistence_pairs(zero=zero)
    assert [(p["dimension"], (p["birth"], p["death"])) for p in pairs] == expected
    plain = flowcert_says("persistence", xyz(points), "-o", "-", "--plain", *options).splitlines()
    roots = [tuple(map(float, line.split())) for line in plain if not line.startswith("#")]
    assert [(d, *ends) for d, ends in fc.persistence(zero=zero, squared=False)] == roots
    for dimension in range(3):
        intervals = fc.persistence(zero=zero, dimension=dimension)
        assert intervals.shape == (sum(d == dimension for d, _ in expected), 2)
        assert intervals.tolist() == [list(ends) for d, ends in expected if d == dimension]
        of_dimension = fc.persistence_pairs(zero=zero, dimension=dimension)
        assert (of_dimension == pairs[pairs["dimension"] == dimension]).all()
        plain_ends = fc.persistence(zero=zero, dimension=dimension, squared=False)
        assert plain_ends.tolist() == [list(root[1:]) for root in roots if root[0] == dimension]
    listed = json.loads(flowcert_says("persistence", xyz(points), "--json", *options))["pairs"]
    assert len(listed) == len(pairs)
    for pair, answer in zip(pairs, listed):
        assert contact(fc, pair["birth_point"]) == answer["birth"]["contact"]
        if answer["death"] is None:
            assert (pair["death_point"], pair["death"]) == (-1, math.inf)
        else:
            assert contact(fc, pair["death_point"]) == answer["death"]["contact"]


def contact(fc, i):
    return fc.contacts[slice(*fc.stationary_points[i]["contact_offsets"])].tolist()


def read_ply(path):
    """(vertices, faces) of a binary PLY file as `flowcert surface` writes it."""
    content = path.read_bytes()
    header, body = content.split(b"end_header\n", 1)
    words = [line.split() for line in header.decode().splitlines()]
    count = {line[1]: int(line[2]) for line in words if line[0] == "element"}
    vertices = np.frombuffer(body, "<f8", 3 * count["vertex"]).reshape(-1, 3)
    faces = []
    offset = vertices.nbytes
    for _ in range(count["face"]):
        corners, *face = struct.unpack_from("<Biii", body, offset)
        assert corners == 3
        faces.append(face)
        offset += 13
    assert offset == len(body)
    return vertices, np.array(faces, dtype=int).reshape(-1, 3)


@pytest.mark.parametrize("select", [None, "index2-radius<1", "largest-gaps=2", ["persistence>0.01", "index2-radius<3"],
                                    "index2-radius<1.6spacing", "persistence>3spacing", "index2-radius<q0.9",
                                    "persistence>q0.9", "index2-radius<auto", "persistence>auto"])  # fmt: skip
def test_surface(points, xyz, tmp_path, select):
    options = [] if select is None else [select] if isinstance(select, str) else select
    words = [word for option in options for word in ("--select", option)]
    flowcert_says("surface", xyz(points), "-o", tmp_path / "shape.ply", "--json", *words)
    vertices, faces = flowcert.FlowComplex(points).surface(select=select)
    expected_vertices, expected_faces = read_ply(tmp_path / "shape.ply")
    assert np.array_equal(vertices, expected_vertices)
    assert np.array_equal(faces, expected_faces)
    assert (vertices.dtype, faces.dtype) == (np.float64, np.int32)


def test_stable_surfaces(points, xyz):
    fc = flowcert.FlowComplex(points)
    surfaces = fc.stable_surfaces()
    mesh = fc.surface()
    assert np.array_equal(surfaces.vertices, mesh.vertices) and np.array_equal(surfaces.faces, mesh.faces)
    _, records = records_of(xyz(points), "--manifolds", "s2")
    expected = {i: 2 * record["stable"]["segments"] for i, record in enumerate(records) if record["index"] == 2}
    assert Counter(surfaces.saddles.tolist()) == {i: count for i, count in expected.items() if count > 0}
    # A face has its saddle's S2 in it: no vertex of it is higher than the saddle.
    highest = surfaces.squared_distances[surfaces.faces].max(axis=1) if len(surfaces.faces) else np.empty(0)
    assert (highest <= fc.critical_points["squared_distance"][surfaces.saddles] * (1 + 1e-12)).all()


def test_unstable_lines(points, xyz):
    fc = flowcert.FlowComplex(points)
    if points is INPUTS["mixed-magnitudes"]:
        with pytest.raises(ValueError, match="^a coordinate is beyond the largest double$"):
            fc.unstable_lines()
        return
    lines = fc.unstable_lines()
    _, records = records_of(xyz(points), "--manifolds", "u2", "--polylines")
    saddles = [i for i, record in enumerate(records) if record["index"] == 2]
    assert lines.saddles.tolist() == [i for i in saddles for side in (0, 1)]
    for line, (saddle, limit) in enumerate(zip(lines.saddles, lines.limits)):
        record = records[saddle]
        side = line % 2
        ends = [record["center"], *(segment["end"] for segment in record["u2"][side] if segment["end"])]
        vertices = lines.vertices[lines.offsets[line] : lines.offsets[line + 1]]
        assert vertices.tolist() == [[float(Fraction(x)) for x in end] for end in ends]
        assert record["limits"][side] == (None if limit == -1 else contact(fc, limit))
        if limit >= 0:
            last = lines.squared_distances[lines.offsets[line + 1] - 1]
            assert last == fc.stationary_points[limit]["squared_distance"]
    assert lines.offsets[-1] == len(lines.vertices) == len(lines.squared_distances)


STARTS = [(0.5, 0.25, 1), (Fraction(1, 3), 0, -2), (1, 1, 0), (0.1, 1e-300, 7)]


@pytest.mark.parametrize("start", STARTS, ids=str)
@pytest.mark.parametrize("name", ["cube", "right-angles", "repeated", "scan", "sphere-scan", "lattice-3"])
def test_orbit(name, start, xyz):
    fc = flowcert.FlowComplex(INPUTS[name])
    orbit = fc.orbit(start=start)
    words = ",".join(f"{Fraction(x).numerator}/{Fraction(x).denominator}" for x in start)
    answer = json.loads(flowcert_says("orbit", xyz(INPUTS[name]), f"--from={words}", "--json"))
    assert orbit.start == ratios(answer["start"]) == tuple(map(Fraction, start))
    assert len(orbit.segments) == len(answer["segments"])
    at = orbit.start
    for segment, expected in zip(orbit.segments, answer["segments"]):
        assert segment.start == at
        assert segment.type == expected["type"] and segment.driver == ratios(expected["driver"])
        assert segment.end == (None if expected["end"] is None else ratios(expected["end"]))
        for part in ("start_contact", "crossed_contact", "end_contact"):
            assert list(getattr(segment, part)) == (expected[part] or [])
        at = segment.end
    limit = answer["limit"]
    if limit["kind"] == "infinity":
        assert orbit.limit is None
        return
    assert orbit.limit.index == (limit["index"] if limit["kind"] == "critical" else -1)
    assert list(orbit.limit.kind) == (limit["index"] if limit["kind"] == "regular" else [limit["index"]] * 2)
    assert orbit.limit.position == ratios(limit["position"]) and list(orbit.limit.contact) == limit["contact"]
    assert orbit.limit.squared_distance == Fraction(limit["squared_distance"])
    assert orbit.vertices.tolist()[-1] == [float(x) for x in orbit.limit.position]


def test_any_number_is_a_coordinate_of_a_start():
    fc = flowcert.FlowComplex(CUBE)
    expected = fc.orbit((Fraction(1, 2), Fraction(1, 4), Fraction(3)))
    assert fc.orbit([np.longdouble(1) / 3, 0, 0]).start[0] == Fraction(*(np.longdouble(1) / 3).as_integer_ratio())
    for start in (
        [0.5, 0.25, 3],
        np.array([0.5, 0.25, 3], dtype=np.float32),
        (np.float16(0.5), 0.25, np.int8(3)),
        (np.longdouble(0.5), Decimal("0.25"), Fraction(3)),
    ):
        assert fc.orbit(start) == expected
    for start, message in [
        ([0, 0], "start must be three numbers, not 2"),
        (1, "start must be three numbers"),
        ([0, 0, math.nan], "start has a coordinate that is not a finite number"),
        ([0, -math.inf, 0], "start has a coordinate that is not a finite number"),
        ([0, 0, Decimal("inf")], "start has a coordinate that is not a finite number"),
        ([0, 0, Decimal("nan")], "start has a coordinate that is not a finite number"),
        ([0, 0, np.longdouble("inf")], "start has a coordinate that is not a finite number"),
        ([0, 0, None], "start must be numbers, not None"),
        ("123", "start must be numbers; for '1' write Fraction('1') or a float"),
    ]:
        with pytest.raises(ValueError) as refused:
            fc.orbit(start)
        assert str(refused.value) == message


@pytest.mark.parametrize("level", [1, 2, 3])
@pytest.mark.parametrize("family", flowcert.families())
def test_generate(family, level, tmp_path):
    points = flowcert.generate(family, 7, level=level, case=3)
    words = ["--family", family, "--seed", "7", "--level", level, "--case", "3", "--hex", "--xyz"]
    path = tmp_path / "case.xyz"
    path.write_text(flowcert_says("generate", *words))
    expected = flowcert.read_points(path)
    assert points.tobytes() == expected.tobytes()
    assert points.flags.writeable and points.flags.c_contiguous


def test_families_and_what_generate_refuses():
    assert len(flowcert.families()) == 36 and all(flowcert.families().values())
    for arguments, message in [
        (("no-such",), "no family is called 'no-such'"),
        (("cube", -1), "seed must be from 0 to 2**64 - 1"),
        (("cube", 2**64), "seed must be from 0 to 2**64 - 1"),
    ]:
        with pytest.raises(ValueError) as refused:
            flowcert.generate(*arguments)
        assert str(refused.value) == message
    with pytest.raises(ValueError):
        flowcert.generate("lattice-2", level=4)
    with pytest.raises(ValueError):
        flowcert.generate("lattice-2", case=10_000_000)
    assert flowcert.generate("lattice-2", 2**64 - 1).shape[1] == 3


def test_files_are_read_as_the_program_reads_them(tmp_path):
    path = tmp_path / "wrong.xyz"
    path.write_text("0 0 0\n1 2\n")
    with pytest.raises(ValueError) as refused:
        flowcert.read_points(path)
    assert str(refused.value).startswith(f"{path}:2: ")
    with pytest.raises(ValueError, match="no-such.ply"):
        flowcert.read_points(tmp_path / "no-such.ply")
    for name, message in [
        (b"missing\xe9.xyz", "missing\ufffd.xyz: cannot open: "),
        ("caf\udce9.xyz", "caf\ufffd.xyz: cannot open: "),
        ("bad\0.xyz", r"'bad\x00.xyz' is no name of a file"),
    ]:
        with pytest.raises(ValueError) as refused:
            flowcert.read_points(name)
        assert str(refused.value).startswith(message)
    path = path.rename(tmp_path / "caf\udce9.xyz")  # a name that is no UTF-8
    path.write_text("1 2 3\n")
    assert flowcert.read_points(path).tolist() == [[1, 2, 3]]
    told = dict.fromkeys(["format", "columns", "z", "atoms", "chains", "models", "frame"])
    assert flowcert.read_points(path, **told).tolist() == [[1, 2, 3]]
    assert flowcert.read_points(path, format="table", columns=[3, "2", 1]).tolist() == [[3, 2, 1]]
    for wrong in ({"format": 1}, {"z": "1"}, {"frame": 0}, {"frame": -1}, {"frame": 2**70}):
        with pytest.raises(ValueError, match="^format must be a str, and z a number$|^frame must be 1 or more$"):
            flowcert.read_points(path, **wrong)


def test_selections_are_the_programs():
    fc = flowcert.FlowComplex(CUBE)
    for select, message in [
        ("radius<1", "select: none of persistence>X, index2-radius<R and largest-gaps=N: 'radius<1'"),
        (["largest-gaps=1", "x"], "select[1]: none of persistence>X, index2-radius<R and largest-gaps=N: 'x'"),
        ("\udce9", "select: none of persistence>X, index2-radius<R and largest-gaps=N: '?'"),
        ([1], "select must be a str, or several"),
        (5, "select must be a str, or several"),
    ]:
        with pytest.raises(ValueError) as refused:
            fc.surface(select=select)
        assert str(refused.value) == message


def test_any_number_of_threads_gives_the_same(points):
    one, four = flowcert.FlowComplex(points, threads=1), flowcert.FlowComplex(points, threads=4)
    assert one.stationary_points.tobytes() == four.stationary_points.tobytes()
    if np.isfinite(one.stationary_points["squared_distance"]).all():
        assert one.persistence() == four.persistence()
    if points is INPUTS["mixed-magnitudes"]:
        return  # its lines are beyond the doubles
    for a, b in zip((*one.unstable_lines(), *one.stable_surfaces()), (*four.unstable_lines(), *four.stable_surfaces())):
        assert np.array_equal(a, b)


def test_the_version_is_the_programs():
    assert flowcert.__version__ in flowcert_says("--version")
    assert flowcert.__made_by__.startswith(f"flowcert {flowcert.__version__} (commit ")
