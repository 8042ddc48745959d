"""Arrays that Hypothesis draws, degenerate on purpose: what must hold of them, the oracle, and GUDHI's persistence.

Points of small lattices have right angles, cospherical sets and repeated rows in nearly all inputs.
"""

import math
from collections import Counter
from fractions import Fraction

import flowcert
import gudhi
import hypothesis
import numpy as np
import pytest
from conftest import json_lines, oracle_says, sphere_sample, write_xyz
from hypothesis import strategies
from hypothesis.extra import numpy as arrays

COORDINATES = {
    "lattice": strategies.integers(-2, 2).map(float),
    "dyadic": strategies.integers(-40, 40).map(lambda k: k / 8),
    "scales": strategies.sampled_from([0.0, 1.0, -1.0, 1e-300, 1e200, 5e-324, 1 + 2**-52]),
}
SMALL = strategies.sampled_from(sorted(COORDINATES)).flatmap(
    lambda name: arrays.arrays(float, strategies.tuples(strategies.integers(0, 9), strategies.just(3)),
                               elements=COORDINATES[name])
)  # fmt: skip
DRAWN = strategies.builds(
    lambda family, seed: flowcert.generate(family, seed, level=1),
    strategies.sampled_from(sorted(flowcert.families())),
    strategies.integers(0, 2**64 - 1),
)


def squared_length(a, b):
    return sum((Fraction(x) - Fraction(y)) ** 2 for x, y in zip(a, b))


@hypothesis.given(points=SMALL | DRAWN)
def test_invariants(points):
    fc = flowcert.FlowComplex(points)
    assert fc.euler_sum == (1 if len(points) else 0)
    assert fc.euler_sum == sum(count * (-1) ** index for index, count in enumerate(fc.counts))
    assert len(fc.critical_points) == sum(fc.counts) and len(fc.regular_points) == sum(fc.regular_counts.values())
    for i, point in enumerate(fc.stationary_points):
        position, squared_distance = fc.exact(i)
        # The contact set is all that is nearest, exactly; a repeated point goes by its first row.
        distances = [squared_length(position, row) for row in points]
        assert min(distances) == squared_distance
        nearest = [row for row, distance in enumerate(distances) if distance == squared_distance]
        first = {points[row].tobytes(): row for row in reversed(range(len(points)))}
        names = sorted({first[(points[row] + 0.0).tobytes()] if (points[row] + 0.0).tobytes() in first else row
                        for row in nearest})  # fmt: skip
        contact = fc.contacts[slice(*point["contact_offsets"])].tolist()
        assert contact == names
        assert [rounded(x) for x in position] == point["center"].tolist()
        assert rounded(squared_distance) == point["squared_distance"]


def rounded(value):
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


@hypothesis.given(points=SMALL | DRAWN)
def test_every_critical_point_is_in_one_pair(points):
    hypothesis.assume(np.abs(points).max(initial=0) < 1e150)
    fc = flowcert.FlowComplex(points)
    pairs = fc.persistence_pairs()
    made = Counter(pairs["birth_point"].tolist() + pairs["death_point"][pairs["death_point"] >= 0].tolist())
    assert made == Counter(range(sum(fc.counts)))
    index = fc.stationary_points["index"]
    assert (index[pairs["birth_point"]] == pairs["dimension"]).all()
    assert np.isinf(pairs["death"]).tolist().count(True) == (1 if len(points) else 0)
    assert (pairs["birth"] <= pairs["death"]).all()
    with_zero = fc.persistence(zero=True)
    kinds = fc.regular_counts
    assert len(with_zero) - len(pairs) == kinds[1, 2] + kinds[2, 3] + 2 * kinds[1, 3]


def test_what_overflows_is_infinite_or_refused():
    points = [[1e200, 0, 0], [-1e200, 0, 0]]
    fc = flowcert.FlowComplex(points)
    assert fc.critical_points["squared_distance"][2] == math.inf and fc.exact(2)[1] == Fraction(1e200) ** 2
    for ask in (fc.persistence, fc.persistence_pairs):
        with pytest.raises(ValueError, match=r"^a squared distance is beyond the largest double; exact\(\) has it$"):
            ask()


@hypothesis.given(points=SMALL | DRAWN)
def test_the_oracle_finds_the_same(points, tmp_path_factory):
    hypothesis.assume(len(points))  # it reads no empty file
    path = write_xyz(tmp_path_factory.getbasetemp() / "drawn.xyz", points)
    fc = flowcert.FlowComplex(points)
    _, *records = json_lines(oracle_says("stationary", "--json", path))
    assert len(records) == len(fc.stationary_points)
    for i, (record, point) in enumerate(zip(records, fc.stationary_points)):
        kind = record["index"] if isinstance(record["index"], list) else [record["index"]] * 2
        assert point["kind"].tolist() == kind
        assert fc.contacts[slice(*point["contact_offsets"])].tolist() == record["contact"]
        position, squared_distance = fc.exact(i)
        assert position == tuple(map(Fraction, record["center"]))
        assert squared_distance == Fraction(record["squared_distance"])


@hypothesis.given(points=SMALL | DRAWN)
def test_its_own_answer_conforms(points):
    fc = flowcert.FlowComplex(points)
    claim = []
    for i, point in enumerate(fc.critical_points):
        position, squared_distance = fc.exact(i)
        claim.append({"index": point["index"], "center": position, "squared_distance": squared_distance})
    report = fc.check(claim)
    assert report.verdict in ("conforms", "conforms where determined"), str(report)
    if claim:
        assert fc.check(claim[1:]).fails


@hypothesis.given(points=SMALL | DRAWN, start=strategies.tuples(*[strategies.fractions(-3, 3, max_denominator=8)] * 3))
def test_orbits_end_at_stationary_points(points, start):
    hypothesis.assume(len(points))
    fc = flowcert.FlowComplex(points)
    orbit = fc.orbit(start)
    if orbit.limit is None:
        assert orbit.segments[-1].end is None
        return
    found = [i for i in range(len(fc.stationary_points)) if fc.exact(i)[0] == orbit.limit.position]
    assert len(found) == 1
    assert tuple(fc.stationary_points[found[0]]["kind"]) == orbit.limit.kind


def gudhi_pairs(points):
    tree = gudhi.AlphaComplex(points=points.tolist(), precision="exact").create_simplex_tree()
    return tree.persistence(homology_coeff_field=2, min_persistence=0)


def assert_like_gudhi(points):
    """By the bottleneck distance, since GUDHI rounds its values."""
    own, other = flowcert.FlowComplex(points).persistence(), gudhi_pairs(points)
    types = [type(part) for pair in own for part in (pair, *pair, *pair[1])]
    assert types == [tuple, int, tuple, float, float] * len(own)
    scale = max(value for _, interval in own for value in interval if value < math.inf) + 1e-300
    for dimension in range(3):
        diagrams = [[interval for d, interval in pairs if d == dimension] for pairs in (own, other)]
        assert gudhi.bottleneck_distance(*diagrams) <= 1e-9 * scale, dimension
    # Beyond rounding, there are as many pairs.
    lasting = [[d for d, (birth, death) in pairs if death - birth > 1e-9 * scale] for pairs in (own, other)]
    assert Counter(lasting[0]) == Counter(lasting[1])


@hypothesis.given(points=DRAWN)
def test_persistence_is_gudhis(points):
    # GUDHI takes no flat input, and squares must not overflow.
    hypothesis.assume(len(points) and np.linalg.matrix_rank(points - points[0]) == 3)
    hypothesis.assume(1e-50 < np.abs(points).max() < 1e50)
    assert_like_gudhi(points)


def test_persistence_of_a_scan_is_gudhis():
    assert_like_gudhi(sphere_sample(2000))
