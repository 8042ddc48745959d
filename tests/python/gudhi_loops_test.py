"""Loops that a reduction of GUDHI's alpha complex gives are judged right by `flowcert check`, on all families.

Where GUDHI's doubles put two exact values in the wrong order, or make one of them, its loops may be wrong. Such inputs
are told by exact values, are counted and listed, and are judged as all others.
"""

import itertools
from fractions import Fraction

import flowcert
import gudhi
import numpy as np
import pytest
from conftest import run, write_xyz

MOST_POINTS, CASES = 16, 2


def reduced_loops(filtration):
    """(birth, death, edges) of each pair of dimension 1, by the standard reduction of boundaries."""
    place = {simplex: k for k, (simplex, _) in enumerate(filtration)}
    columns, loops = {}, []
    for simplex, death in filtration:
        if len(simplex) != 3:
            continue
        column = {place[edge] for edge in itertools.combinations(simplex, 2)}
        while column and max(column) in columns:
            column ^= columns[max(column)]
        if column:
            columns[max(column)] = column
            birth = filtration[max(column)][1]
            if birth < death:
                loops.append((birth, death, [filtration[k][0] for k in column]))
    return loops


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def smallest_sphere(corners):
    """Centre and squared radius of the sphere through the corners that has its centre in their hull's plane."""
    origin, *others = corners
    sides = [[x - y for x, y in zip(corner, origin)] for corner in others]
    rows = [[2 * dot(a, b) for b in sides] + [dot(a, a)] for a in sides]
    for i in range(len(rows)):  # Gauss
        pivot = next(k for k in range(i, len(rows)) if rows[k][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for k in range(len(rows)):
            if k != i:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i])]
    offset = [sum(row[-1] * side[axis] for row, side in zip(rows, sides)) for axis in range(3)]
    return [x + y for x, y in zip(origin, offset)], dot(offset, offset)


def exact_values(simplices, points):
    """The alpha complex's, from its simplices alone: of the smallest sphere if no corner of a coface is inside."""
    exact = [[Fraction(x) for x in row] for row in points.tolist()]
    values = {}
    for simplex in sorted(simplices, key=len, reverse=True):
        center, squared = smallest_sphere([exact[v] for v in simplex])
        cofaces = [other for other in values if len(other) == len(simplex) + 1 and set(simplex) < set(other)]
        apexes = [exact[v] for other in cofaces for v in set(other) - set(simplex)]
        is_empty = all(dot(d, d) >= squared for d in ([x - y for x, y in zip(apex, center)] for apex in apexes))
        values[simplex] = squared if is_empty else min(values[other] for other in cofaces)
    return values


def is_well_ordered(filtration, points):
    values = exact_values([simplex for simplex, _ in filtration], points)
    pairs = sorted((values[simplex], value) for simplex, value in filtration)
    return all((a == c) == (b == d) and b <= d for (a, b), (c, d) in zip(pairs, pairs[1:]))


def inputs():
    for family in flowcert.families():
        for case in range(CASES):
            drawn = [flowcert.generate(family, 47, level=2, case=2 * case + k) for k in range(2)]
            rows = np.unique(np.concatenate(drawn) + 0.0, axis=0)
            if 3 <= len(rows) and np.isfinite(rows).all():
                yield f"{family} {case}", rows[:MOST_POINTS]


@pytest.mark.parametrize("precision", ["exact", "fast"])
def test_loops_of_the_alpha_complex(precision, tmp_path, capsys):
    right = wrong = loops_in_all = 0
    misordered = []
    for name, points in inputs():
        complex = gudhi.AlphaComplex(points=points, precision=precision)
        tree = complex.create_simplex_tree()
        filtration = [(tuple(sorted(simplex)), value) for simplex, value in tree.get_filtration()]
        if tree.num_vertices() != len(points) or not all(np.isfinite(value) for _, value in filtration):
            continue
        loops = reduced_loops(filtration)
        lines = "".join(
            f"pair {birth!r} {death!r}\n" + "".join(f"edge {p} {q}\n" for p, q in edges) for birth, death, edges in loops
        )
        claim = tmp_path / "loops.txt"
        claim.write_text(f"cycles 1\n{lines}")
        verdict = run("FLOWCERT_PROGRAM", "check", write_xyz(tmp_path / "points.xyz", points), claim).splitlines()[-1]
        loops_in_all += len(loops)
        if not is_well_ordered(filtration, points):
            misordered.append((name, verdict.split()[0]))
        else:
            assert verdict.startswith("conforms"), (name, points.tolist(), lines)
        right, wrong = right + verdict.startswith("conforms"), wrong + verdict.startswith("fails")
    with capsys.disabled():
        print(f"\n{precision}: {loops_in_all} loops of {right + wrong} inputs; {wrong} inputs fail", end="")
        print("; values in the wrong order:", ", ".join(" ".join(one) for one in misordered) or "none")
    assert right >= 50 and loops_in_all >= 200
