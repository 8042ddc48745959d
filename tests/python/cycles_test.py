"""Cycles: known loops and voids, what the program writes on all families, and what is refused."""

import json
from collections import Counter
from fractions import Fraction

import flowcert
import hypothesis
import numpy as np
import pytest
from conftest import CUBE, flowcert_says, write_xyz
from degenerate_test import DRAWN, SMALL
from hypothesis import strategies

SQUARE = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]


def contacts(fc, places):
    return [fc.contacts[slice(*fc.stationary_points[i]["contact_offsets"])].tolist() for i in places]


def test_a_square():
    fc = flowcert.FlowComplex(SQUARE)
    [loop] = fc.cycles(level="birth")
    assert loop.polygons[0].tolist() == [0, 1, 2, 3]
    assert loop.edges.tolist() == [[0, 1], [0, 3], [1, 2], [2, 3]]
    assert (loop.squared_level, loop.length) == (1, 8.0)
    assert contacts(fc, loop.saddles) == [[0, 1, 2, 3]]
    # Its boundary is the loop, in halves of edges.
    edges = Counter(tuple(sorted(edge)) for face in loop.surface.faces for edge in zip(face, np.roll(face, -1)))
    outer = [edge for edge, times in edges.items() if times % 2]
    assert len(outer) == 8
    assert sum(np.linalg.norm(np.subtract(*loop.surface.vertices[list(edge)])) for edge in outer) == 8
    [same] = fc.cycles(pair=loop.pair, level=1)
    assert same.edges.tolist() == loop.edges.tolist()
    assert fc.cycles(level=2**0.5 + 0.001) == fc.cycles(dimension=2) == fc.cycles(longest=0) == []
    joined = fc.cycles(dimension=0)
    assert [len(one.components[0]) + len(one.components[1]) for one in joined] == [2, 2, 2]


def test_a_cube_has_a_void():
    fc = flowcert.FlowComplex(CUBE)
    [void] = fc.cycles(dimension=2, level="death")
    assert void.volume == 1
    assert len(void.walls) == 6
    assert contacts(fc, void.maxima) == [list(range(8))]


@hypothesis.given(
    points=SMALL | DRAWN,
    dimension=strategies.sampled_from([0, 1, 2]),
    level=strategies.sampled_from(["birth", "25%", "death", "1/2"]),
)
def test_cycles_are_those_of_the_program(tmp_path_factory, points, dimension, level):
    hypothesis.assume(len(points) > 0)
    fc = flowcert.FlowComplex(points)
    file = tmp_path_factory.mktemp("cycles") / "points.xyz"
    write_xyz(file, points)
    words = ["--dimension", str(dimension), "--level", level, "--persistence", "0", "--json"]
    said = json.loads(flowcert_says("cycles", file, *words))["cycles"]
    found = fc.cycles(dimension, level=Fraction(1, 2) if level == "1/2" else level, persistence=0)
    assert [contacts(fc, cycle.pair) for cycle in found] == [
        [cycle["birth"]["contact"], cycle["death"]["contact"]] for cycle in said
    ]
    for cycle, other in zip(found, said):
        if dimension == 0:
            assert [part.tolist() for part in cycle.components] == other["components"]
            continue
        assert cycle.squared_level == Fraction(other["squared_level"])
        if dimension == 1:
            assert cycle.edges.tolist() == other["edges"]
            assert [polygon.tolist() for polygon in cycle.polygons] == other["polygons"]
            assert contacts(fc, cycle.saddles) == other["surface"]
            assert cycle.length == other["loop_length"]
        else:
            assert contacts(fc, cycle.maxima) == other["maxima"]
            assert contacts(fc, cycle.cell) == [part["contact"] for part in other["cell"]]
            assert contacts(fc, cycle.walls) == other["walls"]
            assert cycle.volume == other["volume"]


@pytest.mark.parametrize(
    "choice, complaint",
    [
        ({"dimension": 3}, "dimension: not 0, 1 or 2, but 3"),
        ({"longest": -1}, "longest: less than 0"),
        ({"level": "100%"}, "level: a share is less than 100%"),
        ({"level": "-1%"}, "level: less than 0"),
        ({"level": "half"}, "level: neither a number, nor a share like 25%, nor birth or death: 'half'"),
        ({"persistence": "much"}, "persistence"),
        ({"pair": (0, 1)}, "no such pair: what is born at 0 lasts"),
        ({"pair": (7, 99)}, "there is no stationary point 99; there are 9"),
        ({"pair": (7, 8), "level": 9}, "the pair is not there at this level"),
        ({"pair": (7, 8), "dimension": 2}, "no such pair: its dimension is 1"),
    ],
)
def test_what_is_refused(choice, complaint):
    with pytest.raises(ValueError, match="^" + complaint.replace("(", r"\(")):
        flowcert.FlowComplex(SQUARE).cycles(**choice)
