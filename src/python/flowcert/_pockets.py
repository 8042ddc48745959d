"""Pockets of the distance function, and where positions flow to."""

from dataclasses import dataclass
from fractions import Fraction
from typing import List, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from . import _exact


class Places(NamedTuple):
    """Where positions flow to.

    limits   (n,) int64: where each ends, a place in stationary_points; -1 for infinity
    nearest  (n,) int64: the row of its nearest point; of several, the first
    tied     (n,) bool: whether several points are nearest
    """

    limits: NDArray[np.int64]
    nearest: NDArray[np.int64]
    tied: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Pocket:
    """What flows to some maxima, merged by persistence. Places are those of stationary_points, ascending.

    peaks       int64 array, its highest maxima: its position
    maxima      int64 array, all its maxima
    depth       float, the distance at the peaks less that at the highest mouth; the nearest double
    difference_of_squares
                Fraction, the difference of the squared distances
    volume      float, of its cell; the nearest double
    cell        int64 array, the stationary points whose stable manifolds make its cell
    mouths      int64 array, the index-2 points that lead out of it
    areas       float64 array, the areas of their stable manifolds, within 2^-40 of themselves
    neighbours  int64 array, other pockets, by place in Pockets.pockets; -1 for the outside
    gates       int64 array, the narrowest places of its widest path to infinity
    lining      int64 array, rows of the points that line it: those nearest to some point inside
    kind        "cavity", "pocket" or "channel" for the probe; None without one
    """

    peaks: NDArray[np.int64]
    maxima: NDArray[np.int64]
    depth: float
    difference_of_squares: Fraction
    volume: float
    cell: NDArray[np.int64]
    mouths: NDArray[np.int64]
    areas: NDArray[np.float64]
    neighbours: NDArray[np.int64]
    gates: NDArray[np.int64]
    lining: NDArray[np.int64]
    kind: Optional[str]


@dataclass(frozen=True, eq=False)
class Pockets:
    """All pockets at one persistence. Places are those of stationary_points, ascending.

    pockets       a list of Pocket, in the order of their first maxima
    outside       int64 array, the maxima that belong to the outside
    gates         int64 array, the narrowest places of the widest path of all; none if there is no pocket. The distance
                  there is the pore limiting radius.
    largest_balls int64 array, the highest maxima of all pockets. The distance there is the largest cavity radius.
    squared_persistence
                  Fraction, the square of the depth up to which maxima were merged
    """

    pockets: List[Pocket]
    outside: NDArray[np.int64]
    gates: NDArray[np.int64]
    largest_balls: NDArray[np.int64]
    squared_persistence: Fraction


def pockets_of(answer):
    pockets, outside, gates, largest_balls, squared_persistence = answer
    made = [Pocket(*some[:3], _exact.fraction(some[3]), *some[4:]) for some in pockets]
    return Pockets(made, outside, gates, largest_balls, _exact.fraction(squared_persistence))
