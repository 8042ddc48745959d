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
    assert (loop.squared_level, loop.loop_length) == (1, 8.0)
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
            assert cycle.loop_length == other["loop_length"]
        else:
            assert contacts(fc, cycle.maxima) == other["maxima"]
            assert contacts(fc, cycle.cell) == [part["contact"] for part in other["cell"]]
            assert contacts(fc, cycle.walls) == other["walls"]
            assert cycle.volume == other["volume"]


RING = [[0, 0, 0], [2, 0, 0], [4, 0, 0], [4, 2, 0], [4, 4, 0], [2, 4, 0], [0, 4, 0], [0, 2, 0]]


def pair_of(fc, birth, death):
    """Of values, which are squared."""
    [pair] = [loop.pair for loop in fc.cycles(persistence=0) if [fc.exact(i)[1] for i in loop.pair] == [birth, death]]
    return pair


def test_loops_represent_a_tunnel():
    fc = flowcert.FlowComplex(RING)
    pair = pair_of(fc, 1, 4)
    around = [0, 1, 2, 3, 4, 5, 6, 7]
    edges = np.column_stack([around, np.roll(around, -1)])
    for loop in (around, [around], edges, edges[::-1], [np.array(around)]):
        assert fc.represents([loop], pair)
    assert not fc.represents([], pair)
    assert not fc.represents([around, around], pair)
    assert not fc.represents([around[:-1]], pair)
    # Its edges have the length of a diagonal, and are split at the corners.
    assert not fc.represents([[1, 3, 5, 7]], pair)
    assert not fc.represents([[1, 3, 5, 7]], pair, Fraction(15, 8))
    assert fc.represents([[1, 3, 5, 7]], pair, 2)
    assert fc.represents([[[1, 3], [3, 5], [5, 7], [7, 1]]], pair, 2.0)


@hypothesis.given(points=SMALL | DRAWN, level=strategies.sampled_from(["birth", "25%", "death"]))
def test_our_loops_represent_their_pairs(points, level):
    hypothesis.assume(len(points) > 0)
    fc = flowcert.FlowComplex(points)
    loops = fc.cycles(level=level, persistence=0)
    by_values = {}
    for loop in loops:
        birth, death = (fc.exact(i)[1] for i in loop.pair)
        by_values.setdefault(death if level != "birth" else (birth, death), []).append(loop)
    for same in by_values.values():
        at = max(loop.squared_level for loop in same)
        if level == "birth" or all(fc.exact(loop.pair[0])[1] <= at for loop in same):
            assert flowcert.represents(same, same[0].pair)
        assert not flowcert.represents(same + same[:1], same[0].pair)
        assert fc.homologous(same[0], same[0].polygons, at)
        assert not fc.homologous(same[0], [], at)
        assert fc.homologous(same[0], [], fc.exact(same[0].pair[1])[1])


def test_loops_are_homologous():
    fc = flowcert.FlowComplex(RING)
    around, inner = [0, 1, 2, 3, 4, 5, 6, 7], [1, 3, 5, 7]
    assert fc.homologous(around, inner, 2)
    assert not fc.homologous(around, inner, Fraction(3, 2)), "an edge leaves the balls"
    assert not fc.homologous(around, [], 3.9)
    assert fc.homologous(around, [], 4)


@pytest.mark.parametrize(
    "loops, pair, level, complaint",
    [
        ([[0, 1, 9]], (7, 8), None, "there is no point 9; there are 4"),
        ([[0, -1, 2]], (7, 8), None, "a loop is a Loop, rows"),
        ([[0.5, 1, 2]], (7, 8), None, "a loop is a Loop, rows"),
        ([[0, 1, 2, 3]], (0, 8), None, "pair: not a critical point of index 1"),
        ([[0, 1, 2, 3]], (7, 8), 2, "squared_level: not from the birth on"),
        ([[0, 1, 2, 3]], (7, 8), 0.5, "squared_level: not from the birth on"),
        ([[0, 1, 2, 3]], (7, 8), "half", "squared_level must be numbers"),
    ],
)
def test_what_represents_refuses(loops, pair, level, complaint):
    with pytest.raises(ValueError, match=complaint):
        flowcert.FlowComplex(SQUARE).represents(loops, pair, level)
    with pytest.raises(ValueError, match="loops: not Loop objects of one complex"):
        flowcert.represents(loops, pair)


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
