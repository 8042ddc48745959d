"""What persistence pairs stand for: loops around tunnels, voids, and components that come together."""

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, List, Optional, Sequence, Tuple, Union

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
    loop_length    float, the length of all edges
    complex        the FlowComplex
    """

    pair: Tuple[int, int]
    squared_level: Fraction
    polygons: List[NDArray[np.int64]]
    edges: NDArray[np.int64]
    saddles: NDArray[np.int64]
    surface: Mesh
    loop_length: float
    complex: Any = field(default=None, repr=False)


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


def cycle_of(complex, dimension, answer):
    pair, squared_level, chain = answer
    if dimension == 0:
        return Joined(pair, chain)
    *some, mesh, measure = chain
    fields = (pair, _exact.fraction(squared_level), *some, Mesh(*mesh), measure)
    return Loop(*fields, complex) if dimension == 1 else Void(*fields)


def edges_of(loop: Any) -> List[List[int]]:
    """Pairs of rows, of a loop in any form."""
    if isinstance(loop, Loop):
        return loop.edges.tolist()
    parts = [np.asarray(part) for part in loop]
    if not parts:
        return []
    if all(part.ndim == 0 for part in parts):
        parts = [np.asarray(loop)]
    if any(part.ndim != 1 or not np.issubdtype(part.dtype, np.integer) or part.min(initial=0) < 0 for part in parts):
        raise ValueError("a loop is a Loop, rows of a closed polygon, several such polygons, or edges of two rows")
    if all(len(part) == 2 for part in parts):
        return [part.tolist() for part in parts]
    return [[int(a), int(b)] for part in parts for a, b in zip(part, np.roll(part, -1))]


def represents(loops: Sequence[Loop], pair: Tuple[int, int], squared_level: Optional[Any] = None) -> bool:
    """Whether loops that `FlowComplex.cycles` gives are a basis of what stands for pairs (FlowComplex.represents).

    >>> fc = FlowComplex([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
    >>> loops = fc.cycles()
    >>> represents(loops, loops[0].pair)
    True
    """
    complexes = {id(loop.complex): loop.complex for loop in loops if isinstance(loop, Loop)}
    if len(complexes) != 1:
        raise ValueError("loops: not Loop objects of one complex; FlowComplex.represents takes others")
    [complex] = complexes.values()
    return complex.represents(loops, pair, squared_level)
