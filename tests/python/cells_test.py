"""Volumes, λ-lists, connections and unstable surfaces: known values, what the program writes on all families, and what
is refused.
"""

import math
from collections import Counter
from fractions import Fraction

import flowcert
import hypothesis
import numpy as np
import pytest
from conftest import CUBE, flowcert_says, json_lines
from degenerate_test import DRAWN, SMALL
from hypothesis import strategies

# A saddle flows to a saddle, whose stable manifold has dimension 3.
FIVE = np.array([[0, 5, 0], [-3, 0, -2], [3, 0, -2], [0, 0, 12], [0, -5, 0]], dtype=float)
CHAIN = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [2, 1, 1]], dtype=float)
PYRAMID = np.array([[-1, -1, 0], [-1, 1, 0], [1, -1, 0], [1, 1, 0], [0, 0, 3]], dtype=float)
OCTAHEDRON = np.concatenate([np.eye(3), -np.eye(3)])
FLAT = {
    "none": np.empty((0, 3)),
    "one": CUBE[:1],
    "two": CUBE[:2],
    "line": np.outer(np.arange(4.0), [1, 2, 3]),
    "square": CUBE[:4],
    "repeated": np.concatenate([CUBE[:3], CUBE[:3]]),
}


def contact(fc, i):
    return fc.contacts[slice(*fc.stationary_points[i]["contact_offsets"])].tolist()


def positive_volumes(fc):
    """{kind: exact volumes}"""
    found = {}
    for i in fc.volumes.nonzero()[0]:
        found.setdefault(tuple(fc.stationary_points[i]["kind"].tolist()), []).append(fc.volume(i))
    return found


@pytest.mark.parametrize(
    "points, expected, hull, is_morse_smale",
    [
        (CUBE, {(3, 3): [1]}, 1, True),
        (OCTAHEDRON, {(3, 3): [Fraction(4, 3)]}, Fraction(4, 3), True),
        (OCTAHEDRON[:5], {(2, 3): [Fraction(2, 3)]}, Fraction(2, 3), False),
        (PYRAMID, {(3, 3): [4]}, 4, True),
        (FIVE, {(2, 2): [50], (3, 3): [45, 45]}, 140, False),
        (CHAIN, {(1, 3): [Fraction(1, 6)] * 2}, Fraction(1, 3), False),
    ],
    ids=["cube", "octahedron", "half-octahedron", "pyramid", "five", "chain"],
)
def test_known_volumes(points, expected, hull, is_morse_smale):
    fc = flowcert.FlowComplex(points)
    assert positive_volumes(fc) == expected
    assert (fc.hull_volume, fc.is_morse_smale) == (hull, is_morse_smale)
    assert type(fc.hull_volume) is Fraction and type(fc.is_morse_smale) is bool


def test_a_cube_belongs_to_its_corners_in_equal_parts():
    fc = flowcert.FlowComplex(np.concatenate([CUBE[:1], CUBE]))
    maximum = int(np.flatnonzero(fc.critical_points["index"] == 3)[0])
    # The second row repeats the first, and has no volume of its own.
    assert fc.shares(maximum, exact=True) == {row: Fraction(1, 8) for row in (0, *range(2, 9))}
    assert fc.shares(0, exact=True) == {}
    assert fc.lambda_list(8).arcs == (None, maximum)
    volumes = fc.volumes
    volumes[:] = 7  # the caller's
    assert fc.volumes[maximum] == 1


def test_a_saddle_leads_to_a_saddle():
    fc = flowcert.FlowComplex(FIVE)
    place = {tuple(contact(fc, i)): i for i in range(len(fc.stationary_points))}
    assert (place[0, 1, 2], place[0, 3, 4]) in {(y, z) for y, z, _, _ in fc.connections.tolist()}
    [to] = [entry for entry in fc.connections if (entry["from"], entry["to"]) == (place[0, 1, 2], place[0, 3, 4])]
    assert (to["orbits"], to["families"]) == (1, 0)
    with pytest.raises(ValueError, match="^stationary point 0 has no list of limits; saddles and regular points "):
        fc.lambda_list(0)


@pytest.mark.parametrize("name", FLAT)
def test_flat_inputs_have_no_volume(name):
    fc = flowcert.FlowComplex(FLAT[name])
    assert fc.hull_volume == 0 and fc.volumes.shape == (len(fc.stationary_points),) and not fc.volumes.any()
    assert fc.volumes.dtype == np.float64
    assert all(fc.volume(i) == 0 and fc.shares(i) == {} for i in range(len(fc.stationary_points)))
    # All else goes to infinity.
    ends = fc.connections["to"]
    assert ((ends == -1) | (ends >= sum(fc.counts[:2]))).all()
    assert len(fc.connections) >= sum(fc.counts[1:])


def test_two_points_have_a_circle_that_leads_to_infinity():
    fc = flowcert.FlowComplex(FLAT["two"])
    assert fc.lambda_list(2) == fc.lambda_list(2, exact=True) == flowcert.LambdaList((), (None,))
    assert fc.connections.tolist() == [(2, -1, 0, 1)] and fc.is_morse_smale
    none = flowcert.FlowComplex(FLAT["none"])
    assert none.connections.tolist() == [] and none.is_morse_smale


def test_vectors_and_exits():
    fc = flowcert.FlowComplex([[0, 0, 0], [2, 0, 0], [0, 2, 0]])  # the circle's centre is on an edge
    assert fc.regular_counts[1, 2] == 1
    regular = len(fc.stationary_points) - 1
    exact = fc.lambda_list(regular, exact=True)
    assert [direction.is_vector for direction in exact.directions] == [True, True]
    assert sorted(direction.exit for direction in exact.directions) == [(0, 0, -1), (0, 0, 1)]
    assert [type(x) for direction in exact.directions for x in direction.exit] == [Fraction] * 6
    rounded = fc.lambda_list(np.int8(regular))
    assert [type(x) for direction in rounded.directions for x in direction.exit] == [float] * 6
    assert all(math.copysign(1, x) == 1 for direction in rounded.directions for x in direction.exit if x == 0)


def test_numbers_beyond_the_doubles():
    fc = flowcert.FlowComplex(CUBE * 2.0**400)
    maximum = int(fc.volumes.argmax())
    assert fc.volumes[maximum] == math.inf
    assert fc.volume(maximum) == fc.hull_volume == 2**1200
    assert sum(fc.shares(maximum, exact=True).values()) == 2**1200
    assert set(fc.shares(maximum).values()) == {math.inf}


@pytest.mark.parametrize("ask", ["volume", "shares", "lambda_list", "unstable_surface"])
def test_places(ask):
    fc = flowcert.FlowComplex(CUBE[:2])
    for i in (3, -1, 2**63 - 1, 2**64, -(10**30)):
        with pytest.raises(ValueError) as refused:
            getattr(fc, ask)(i)
        assert str(refused.value) == f"there is no stationary point {i}; there are 3"
    with pytest.raises(TypeError):
        getattr(fc, ask)(1.0)


# ---- What the program writes


def limit_of(fc, place):
    return None if place is None else contact(fc, place)


def written(direction):
    return direction["vector" if "vector" in direction else "exit"]


@pytest.mark.parametrize("name", ["cube", "five", "chain", "scan", *flowcert.families()])
def test_all_of_it_is_what_the_program_writes(name, xyz):
    given = {"cube": CUBE, "five": FIVE, "chain": CHAIN, "scan": np.random.default_rng(3).uniform(size=(60, 3))}
    points = given[name] if name in given else flowcert.generate(name, seed=6, level=2)
    fc = flowcert.FlowComplex(points)
    header, *records = json_lines(flowcert_says("compute", xyz(points), "--manifolds", "all", "--volumes", "exact",
                                                "-o", "-"))  # fmt: skip
    assert fc.is_morse_smale == header["morse_smale"] and fc.hull_volume == Fraction(header["hull_volume"])
    connections = [(y, -1 if z is None else z, orbits, families) for y, record in enumerate(records)
                   for z, orbits, families in connections_of(record, records)]  # fmt: skip
    assert fc.connections.tolist() == connections
    for i, record in enumerate(records):
        assert fc.volume(i) == Fraction(record["volume"])
        overflows = record["volume_double"] is None
        assert fc.volumes[i] == (math.inf if overflows else record["volume_double"])
        shares = fc.shares(i, exact=True)
        assert list(shares.items()) == [(row, Fraction(share)) for row, share in record.get("shares", [])]
        assert fc.shares(i) == {row: nearest(share) for row, share in shares.items()}
        if "lambda" not in record:
            with pytest.raises(ValueError, match=f"^stationary point {i} has no list of limits"):
                fc.lambda_list(i)
            continue
        lists = fc.lambda_list(i), fc.lambda_list(i, exact=True)
        expected = record["lambda"]
        for found in lists:
            assert [limit_of(fc, limit) for limit in found.arcs] == expected["arcs"]
            assert [limit_of(fc, direction.limit) for direction in found.directions] == [
                direction["limit"] for direction in expected["directions"]
            ]
            assert [direction.is_vector for direction in found.directions] == [
                "vector" in direction for direction in expected["directions"]
            ]
        for rounded, exact, direction in zip(lists[0].directions, lists[1].directions, expected["directions"]):
            assert exact.exit == tuple(map(Fraction, written(direction)))
            assert rounded.exit == tuple(map(nearest, exact.exit))


def nearest(value):
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def connections_of(record, records):
    place = {tuple(other["contact"]): i for i, other in enumerate(records)}
    for connection in record.get("connections", []):
        to = connection["to"]
        yield None if to is None else place[tuple(to)], connection["orbits"], connection["families"]


def written_corner(corner):
    is_vector = isinstance(corner, dict)
    return flowcert.SurfaceCorner(tuple(map(Fraction, corner["vector"] if is_vector else corner)), is_vector)


def written_intervals(intervals):
    return tuple(flowcert.UnstableInterval(tuple(one["polygon"]),
                                           (written_corner(one["from"]), written_corner(one["to"])))
                 for one in intervals)  # fmt: skip


def written_surface(u1):
    return flowcert.UnstableSurface(
        tuple(tuple(map(Fraction, vertex)) for vertex in u1["vertices"]),
        written_intervals(u1["traces"]),
        written_intervals(u1["runs"]),
        tuple(
            flowcert.UnstableSheet(tuple(sheet["samples"]), tuple(map(written_corner, sheet["corners"])))
            for sheet in u1["sheets"]
        ),
        tuple(
            flowcert.UnstableSegment(tuple(one["samples"]), tuple(map(Fraction, one["start"])),
                                     written_corner(one["end"]))
            for one in u1["segments"]
        ),  # fmt: skip
    )


def rounded_corner(corner):
    return flowcert.SurfaceCorner(tuple(map(nearest, corner.position)), corner.is_vector)


def rounded_intervals(intervals):
    return tuple(flowcert.UnstableInterval(one.polygon, tuple(map(rounded_corner, one.ends))) for one in intervals)


def rounded_surface(surface):
    return flowcert.UnstableSurface(
        tuple(tuple(map(nearest, vertex)) for vertex in surface.vertices),
        rounded_intervals(surface.traces),
        rounded_intervals(surface.runs),
        tuple(
            flowcert.UnstableSheet(sheet.samples, tuple(map(rounded_corner, sheet.corners)))
            for sheet in surface.sheets
        ),
        tuple(
            flowcert.UnstableSegment(one.samples, tuple(map(nearest, one.start)), rounded_corner(one.end))
            for one in surface.segments
        ),
    )


@pytest.mark.parametrize("name", ["cube", "five", "chain", *flowcert.families()])
def test_unstable_surfaces_are_what_the_program_writes(name, xyz):
    given = {"cube": CUBE, "five": FIVE, "chain": CHAIN}
    points = given[name] if name in given else flowcert.generate(name, seed=6, level=2)[:40]
    fc = flowcert.FlowComplex(points)
    _, *records = json_lines(flowcert_says("compute", xyz(points), "--manifolds", "all", "--sheets", "-o", "-"))
    for i, record in enumerate(records):
        if "u1" not in record:
            with pytest.raises(ValueError, match=f"^stationary point {i} has no unstable surface; those of index 1"):
                fc.unstable_surface(i)
            continue
        exact = fc.unstable_surface(i, exact=True)
        assert exact == written_surface(record["u1"])
        assert fc.unstable_surface(np.int64(i)) == rounded_surface(exact)


def test_an_unstable_surface_of_a_cube():
    fc = flowcert.FlowComplex(CUBE)
    surface = fc.unstable_surface(8, exact=True)
    half = Fraction(1, 2)
    assert surface.vertices == ((half, half, half),) and surface.runs == surface.segments == ()
    assert [trace.ends[0] for trace in surface.traces] == [flowcert.SurfaceCorner((half, half, half), False)] * 2
    [sheet] = surface.sheets
    assert sheet.samples == tuple(contact(fc, 8)) and [corner.is_vector for corner in sheet.corners] == [0, 1, 1]
    assert all(type(x) is Fraction for corner in sheet.corners for x in corner.position)
    rounded = fc.unstable_surface(8)
    assert rounded == rounded_surface(surface)
    assert all(type(x) is float and math.copysign(1, x or 1.0) == 1 for x in rounded.vertices[0])


# ---- What must hold


@hypothesis.given(points=SMALL | DRAWN)
def test_volumes_add_up(points):
    fc = flowcert.FlowComplex(points)
    volumes = [fc.volume(i) for i in range(len(fc.stationary_points))]
    assert fc.volumes.tolist() == list(map(nearest, volumes))
    for i, volume in enumerate(volumes):
        assert sum(fc.shares(i, exact=True).values()) == volume
        assert volume > 0 or fc.stationary_points["index"][i] != 3
    assert sum(volumes) <= fc.hull_volume


@hypothesis.given(points=SMALL | DRAWN, data=strategies.data())
def test_connections_are_counted_from_lists(points, data):
    fc = flowcert.FlowComplex(points)
    connections = fc.connections.tolist()
    assert len({(y, z) for y, z, _, _ in connections}) == len(connections)
    for y, z, orbits, families in connections:
        assert orbits + families > 0
        assert z == -1 or fc.exact(y)[1] < fc.exact(z)[1]
    starts = sorted({y for y, _, _, _ in connections})
    hypothesis.assume(starts)
    y = data.draw(strategies.sampled_from(starts))
    found = fc.lambda_list(y, exact=True)
    arcs = Counter(-1 if limit is None else limit for limit in found.arcs)
    assert arcs == Counter({z: families for start, z, _, families in connections if start == y and families})
    for direction in found.directions:
        if not direction.is_vector:
            limit = fc.orbit(direction.exit).limit
            assert (limit is None) == (direction.limit is None)
            assert limit is None or limit.position == fc.exact(direction.limit)[0]
