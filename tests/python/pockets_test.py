"""Pockets and locations: known values, what the program writes on all families, and what is refused."""

import json
from fractions import Fraction

import flowcert
import hypothesis
import numpy as np
import pytest
from conftest import CUBE, flowcert_says, write_xyz
from degenerate_test import DRAWN, SMALL
from hypothesis import strategies

OCTAHEDRON = np.concatenate([np.eye(3), -np.eye(3)])


def contacts(fc, places):
    return [fc.contacts[slice(*fc.stationary_points[i]["contact_offsets"])].tolist() for i in places]


def test_an_octahedron():
    fc = flowcert.FlowComplex(OCTAHEDRON)
    found = fc.pockets(0, probe=Fraction(2, 3))
    [pocket] = found.pockets
    assert contacts(fc, pocket.peaks) == [[0, 1, 2, 3, 4, 5]]
    assert (pocket.volume, pocket.difference_of_squares, pocket.kind) == (4 / 3, Fraction(1, 3), "channel")
    assert pocket.neighbours.tolist() == [-1]
    assert pocket.areas == pytest.approx([3**0.5 / 2] * 8)
    assert found.gates.tolist() == pocket.mouths.tolist() == pocket.gates.tolist()
    assert found.largest_balls.tolist() == pocket.peaks.tolist()
    assert found.squared_persistence == 0
    assert pocket.lining.tolist() == [0, 1, 2, 3, 4, 5]
    assert fc.pockets(persistence="q1").outside.tolist() == pocket.maxima.tolist()


@hypothesis.given(points=SMALL | DRAWN, persistence=strategies.sampled_from(["0", "q0.5", "auto", "1/4"]))
def test_pockets_are_those_of_the_program(tmp_path_factory, points, persistence):
    hypothesis.assume(len(points) > 0)
    fc = flowcert.FlowComplex(points)
    file = tmp_path_factory.mktemp("pockets") / "points.xyz"
    write_xyz(file, points)
    said = json.loads(flowcert_says("pockets", file, "--persistence", persistence, "--probe", "0.5", "--json"))
    found = fc.pockets(persistence if not persistence[0].isdigit() else Fraction(persistence), probe=0.5)
    assert found.squared_persistence == Fraction(said["squared_persistence"])
    assert contacts(fc, found.outside) == said["outside"]
    assert len(found.pockets) == len(said["pockets"])
    for pocket, other in zip(found.pockets, said["pockets"]):
        assert contacts(fc, pocket.maxima) == other["maxima"]
        assert contacts(fc, pocket.peaks) == [peak["contact"] for peak in other["peaks"]]
        assert contacts(fc, pocket.cell) == [part["contact"] for part in other["cell"]]
        assert contacts(fc, pocket.mouths) == [mouth["contact"] for mouth in other["mouths"]]
        assert contacts(fc, pocket.gates) == [gate["contact"] for gate in other["widest_path"]["gates"]]
        areas = [None if np.isinf(area) else area for area in pocket.areas.tolist()]
        assert areas == [mouth["area"] for mouth in other["mouths"]]
        assert pocket.neighbours.tolist() == other["neighbours"]
        assert pocket.difference_of_squares == Fraction(other["difference_of_squares"])
        assert pocket.lining.tolist() == other["lining"]
        numbers = [None if np.isinf(number) else number for number in (pocket.depth, pocket.volume)]
        assert (*numbers, pocket.kind) == (other["depth"], other["volume"], other["is"])


@hypothesis.given(points=SMALL | DRAWN, seed=strategies.integers(0, 2**32 - 1))
def test_locations_are_the_ends_of_orbits(points, seed):
    hypothesis.assume(len(points) > 0 and np.abs(points).max() < 1e300)
    fc = flowcert.FlowComplex(points)
    random = np.random.default_rng(seed)
    middles = (points[random.integers(len(points), size=4)] + points[random.integers(len(points), size=4)]) / 2
    queries = np.concatenate([points[:2], middles, 2 * middles])
    limits, nearest, tied = fc.locate(positions=queries)
    assert limits.dtype == nearest.dtype == np.int64 and tied.dtype == bool
    for x, limit, row, is_tied in zip(queries, limits, nearest, tied):
        end = fc.orbit(x).limit
        assert (end is None) == (limit == -1)
        if end is not None:
            assert list(end.contact) == contacts(fc, [limit])[0]
        distances = [sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(x.tolist(), p.tolist())) for p in points]
        least = [k for k, distance in enumerate(distances) if distance == min(distances)]
        assert row == least[0]
        assert is_tied == (len({tuple(points[k]) for k in least}) > 1)


def test_what_is_refused():
    fc = flowcert.FlowComplex(CUBE)
    for persistence in [-1, "many", "q2", float("nan"), [1]]:
        with pytest.raises(ValueError, match="persistence"):
            fc.pockets(persistence)
    with pytest.raises(ValueError, match="probe: not 0 or more"):
        fc.pockets(probe=-1)
    with pytest.raises(ValueError, match="shape"):
        fc.locate([1, 2, 3])
    with pytest.raises(ValueError, match="finite"):
        fc.locate([[1, 2, float("inf")]])
    with pytest.raises(ValueError, match="no points"):
        flowcert.FlowComplex(np.empty((0, 3))).locate(CUBE)
    assert flowcert.FlowComplex(np.empty((0, 3))).pockets().pockets == []
    assert fc.locate(np.empty((0, 3))).limits.shape == (0,)


def test_atoms_that_line_a_pocket(tmp_path):
    rows = [("CA", "GLY", 7), ("N", "GLY", 7), ("CA", "ALA", 8), ("N", "ALA", 8), ("CA", "SER", 9), ("N", "SER", 9)]
    file = tmp_path / "octahedron.pdb"
    file.write_text("".join(
        f"ATOM  {k + 1:>5}  {atom:<3} {residue} A{number:>4}    {x:>8.3f}{y:>8.3f}{z:>8.3f}  1.00  0.00           {atom[0]}\n"
        for k, ((atom, residue, number), (x, y, z)) in enumerate(zip(rows, 4 * OCTAHEDRON))))  # fmt: skip
    points, atoms = flowcert.read_points(file, return_atoms=True)
    assert points.shape == (6, 3) and len(atoms) == 6
    assert atoms.dtype.names == ("chain", "residue", "number", "atom", "element")
    assert atoms[["residue", "number", "atom"]].tolist() == [(r, str(n), a) for a, r, n in rows]
    [pocket] = flowcert.FlowComplex(points).pockets(0).pockets
    assert atoms["residue"][pocket.lining].tolist() == [residue for _, residue, _ in rows]
    assert flowcert.FlowComplex(points).pockets().pockets == []  # not deeper than half the spacing
    write_xyz(tmp_path / "a.xyz", points)
    points, left_out, none = flowcert.read_points(tmp_path / "a.xyz", return_atoms=True, return_left_out=True)
    assert len(none) == len(left_out) == 0
