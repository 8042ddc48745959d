"""Where the flow takes a position, exactly."""

from dataclasses import dataclass
from fractions import Fraction
from typing import Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _exact

Position = Tuple[Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class Segment:
    """A straight piece of an orbit. Positions are triples of Fractions, contact sets are ascending rows of the points.

    type             the Voronoi faces where it starts, which it crosses, and which it reaches: "E-F-V", "V-E-inf"
    start, end       where it starts and ends; end is None at infinity
    driver           the point that it flows away from
    start_contact    the points that are nearest to its start
    crossed_contact  those on the way
    end_contact      those nearest to its end; none at infinity
    """

    type: str
    start: Position
    driver: Position
    end: Optional[Position]
    start_contact: Tuple[int, ...]
    crossed_contact: Tuple[int, ...]
    end_contact: Tuple[int, ...]


@dataclass(frozen=True)
class Limit:
    """The stationary point at which an orbit ends.

    index             0 to 3, or -1 if the point is regular
    kind              (i, i) for a critical point of index i; (1, 2), (1, 3) or (2, 3) for a regular stationary point
    position          three Fractions, in the unit of the points
    squared_distance  a Fraction, to the nearest points
    contact           their rows, ascending
    """

    index: int
    kind: Tuple[int, int]
    position: Position
    squared_distance: Fraction
    contact: Tuple[int, ...]


@dataclass(frozen=True)
class Orbit:
    """The way of a position along the flow, segment by segment, all exact.

    start     three Fractions
    segments  a tuple of Segment, empty if the start is stationary
    limit     a Limit, or None if the orbit goes to infinity
    """

    start: Position
    segments: Tuple[Segment, ...]
    limit: Optional[Limit]

    @property
    @_exact.in_ieee_doubles
    def vertices(self) -> NDArray[np.float64]:
        """(k, 3): the start and all ends but infinity, in the nearest doubles."""
        ends = [segment.end for segment in self.segments if segment.end is not None]
        return np.array([[float(x) for x in position] for position in [self.start, *ends]])


def orbit_of(start, answer):
    segments, limit = answer
    return Orbit(start, tuple(map(_segment, segments)), None if limit is None else _limit(*limit))


def _segment(fields):
    kind, start, driver, end, *contacts = fields
    return Segment(
        kind,
        _exact.fractions(start),
        _exact.fractions(driver),
        None if end is None else _exact.fractions(end),
        *map(tuple, contacts),
    )


def _limit(kind, position, squared_distance, contact):
    index = kind[0] if kind[0] == kind[1] else -1
    return Limit(index, kind, _exact.fractions(position), _exact.fraction(squared_distance), tuple(contact))
