"""Exact numbers of any length come through."""

import math
import sys
from fractions import Fraction

import flowcert
import numpy as np
import pytest

# A tetrahedron around its centre, with the least double instead of zeros, and large: thousands of bits.
TINY = 5e-324
TALL = 2.0**900
LONG = [[TALL, TINY, -0.7 * TALL], [-TALL, 3 * TINY, -0.7 * TALL], [5 * TINY, TALL, 0.7], [7 * TINY, -TALL, 0.7 * TALL]]


def squared_length(a, b):
    return sum((Fraction(x) - Fraction(y)) ** 2 for x, y in zip(a, b))


def test_more_than_4300_digits():
    fc = flowcert.FlowComplex(LONG)
    longest = 0
    for i, point in enumerate(fc.stationary_points):
        position, squared_distance = fc.exact(i)
        assert all(isinstance(value, Fraction) for value in (*position, squared_distance))
        assert min(squared_length(position, row) for row in LONG) == squared_distance
        for row in fc.contacts[slice(*point["contact_offsets"])]:
            assert squared_length(position, LONG[row]) == squared_distance
        longest = max(longest, squared_distance.numerator.bit_length())
    assert longest * math.log10(2) > 4300
    # Python has this limit, which is why the numbers are passed in hexadecimal.
    limit = getattr(sys, "get_int_max_str_digits", lambda: 0)()
    if limit:
        with pytest.raises(ValueError):
            str(fc.exact(len(fc.stationary_points) - 1)[1].numerator * 10**limit)


def test_long_numbers_are_claims_and_starts():
    fc = flowcert.FlowComplex(LONG)
    claim = []
    for i, point in enumerate(fc.critical_points):
        position, squared_distance = fc.exact(i)
        claim.append({"index": point["index"], "center": position, "squared_distance": squared_distance})
    report = fc.check(claim)
    assert report.verdict == "conforms" and report.is_exact
    position, _ = fc.exact(len(fc.critical_points) - 1)
    orbit = fc.orbit(position)
    assert orbit.segments == () and orbit.limit.position == position


def test_places():
    fc = flowcert.FlowComplex([[0, 0, 0], [1, 0, 0]])
    assert fc.exact(np.int8(2)) == ((Fraction(1, 2), 0, 0), Fraction(1, 4))
    for i in (3, -1, 2**63 - 1, 2**63, 2**64, 10**30, -(10**30)):
        with pytest.raises(ValueError) as refused:
            fc.exact(i)
        assert str(refused.value) == f"there is no stationary point {i}; there are 3"
    with pytest.raises(TypeError):
        fc.exact(1.0)
