"""What persistence pairs stand for: loops around tunnels, voids, and components that come together."""

from dataclasses import dataclass
from fractions import Fraction
from typing import List, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _exact
from ._manifolds import Mesh


@dataclass(frozen=True, eq=False)
class Loop:
    """A pair of dimension 1: a loop around a tunnel at a level, and a surface that fills it.

    pair           (birth, death), places in critical_points
    squared_level  Fraction, the square of the distance at which the loop is shown
    polygons       a list of int64 arrays, rows of points: the loop as closed polygons, which have no repetition
    edges          (k, 2) int64, the same loop as edges, rows of points
    saddles        int64 array, the index-2 points whose stable manifolds make the surface, places in critical_points
    surface        a Mesh; the boundary of its triangles is the loop, mod 2
    length         float, the length of all edges
    """

    pair: Tuple[int, int]
    squared_level: Fraction
    polygons: List[NDArray[np.int64]]
    edges: NDArray[np.int64]
    saddles: NDArray[np.int64]
    surface: Mesh
    length: float


@dataclass(frozen=True, eq=False)
class Void:
    """A pair of dimension 2: where points are farther away than a level, within walls. Places are those of
    stationary_points, ascending.

    pair           (birth, death), places in critical_points
    squared_level  Fraction, the square of the distance at which the void is shown
    maxima         int64 array, the maxima in it
    cell           int64 array, the stationary points whose stable manifolds make its cell
    walls          int64 array, the index-2 points that lead into it and out of it
    surface        a Mesh, the closed surface of the cell, its faces counterclockwise, seen from outside
    volume         float, of the cell; the nearest double
    """

    pair: Tuple[int, int]
    squared_level: Fraction
    maxima: NDArray[np.int64]
    cell: NDArray[np.int64]
    walls: NDArray[np.int64]
    surface: Mesh
    volume: float


@dataclass(frozen=True, eq=False)
class Joined:
    """A pair of dimension 0: two components, and where they come together.

    pair        (birth, death), places in critical_points
    components  two int64 arrays, the rows of the points of both, ascending
    """

    pair: Tuple[int, int]
    components: Tuple[NDArray[np.int64], NDArray[np.int64]]


Cycle = Union[Loop, Void, Joined]


def cycle_of(dimension, answer):
    pair, squared_level, chain = answer
    if dimension == 0:
        return Joined(pair, chain)
    *some, mesh, measure = chain
    return (Loop if dimension == 1 else Void)(pair, _exact.fraction(squared_level), *some, Mesh(*mesh), measure)
