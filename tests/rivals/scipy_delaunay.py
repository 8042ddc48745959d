"""SciPy's Delaunay triangulation (Qhull; Debian's python3-scipy) with Gabriel tests in doubles.

KIND is plain, SciPy's own options, or joggled, Qhull's QJ. A simplex is claimed if its circumcentre, as computed in
doubles, is inside of it, and no other point is nearer to it. There is no tolerance.
KIND-cells: the cells themselves, as lines of ids, for triangulations.py.
"""

from itertools import combinations

import numpy
from scipy.spatial import Delaunay

import answering

OPTIONS = {"plain": None, "joggled": "QJ"}


def circumcentre(corners):
    """The centre and its weights, or none where the matrix is singular."""
    edges = corners[1:] - corners[0]
    if not len(edges):
        return corners[0], numpy.ones(1)
    try:
        weights = numpy.linalg.solve(2 * edges @ edges.T, (edges * edges).sum(axis=1))
    except numpy.linalg.LinAlgError:
        return None
    return corners[0] + weights @ edges, numpy.append(weights, 1 - weights.sum())


def is_critical(points, simplex):
    if max(simplex) >= len(points):
        return True  # Qhull named a point that there is not: the judge is to see that
    corners = points[list(simplex)]
    found = circumcentre(corners)
    if found is None or not (found[1] > 0).all():
        return False
    squares = ((points - found[0]) ** 2).sum(axis=1)
    others = numpy.delete(squares, simplex)
    return not len(others) or others.min() >= squares[simplex[0]]


def answer_of(kind, rows):
    points = numpy.array(rows, dtype=float).reshape(-1, 3)
    options, _, what = kind.partition("-")
    cells = Delaunay(points, qhull_options=OPTIONS[options]).simplices.tolist()
    if what == "cells":
        return "".join(" ".join(map(str, cell)) + "\n" for cell in cells)
    simplices = {tuple(sorted(face)) for cell in cells for size in (1, 2, 3, 4)
                 for face in combinations(cell, size)}
    return "".join(f"{len(simplex) - 1},,,,,{','.join(map(str, simplex))}\n"
                   for simplex in sorted(simplices) if is_critical(points, simplex))


if __name__ == "__main__":
    answering.main([options + what for what in ("", "-cells") for options in OPTIONS], answer_of)
