"""Where the directions of a stationary point lead."""

from dataclasses import dataclass
from typing import Optional, Tuple, Union

from . import _exact
from ._orbit import Position


@dataclass(frozen=True)
class Direction:
    """A single direction of a stationary point.

    limit      where its orbits end, a place in stationary_points; None for infinity
    exit       where its ray leaves the closed Voronoi face, in the unit of the points; the nearest doubles, of which
               one is infinite where it would overflow, or Fractions
    is_vector  whether the ray never leaves it; then exit is a vector along it, whose greatest coordinate is 1 or -1
    """

    limit: Optional[int]
    exit: Union[Tuple[float, float, float], Position]
    is_vector: bool


@dataclass(frozen=True)
class LambdaList:
    """Where the directions of a stationary point lead: single directions and open arcs between them take turns.

    directions  a tuple of Direction
    arcs        a tuple, the limits of the arcs: places in stationary_points, or None for infinity. Arc i comes after
                direction i.

    An index-1 point has a cycle, counterclockwise seen from the nearest point with the greater row. It begins with the
    least exit, in lexicographic order, and after the last direction comes the last arc. A whole circle of one limit is
    one arc and no direction. A point of kind (1, 2) or (1, 3) has one arc less than directions. An index-2 point has
    two directions and no arc, and one of kind (2, 3) has one direction.
    """

    directions: Tuple[Direction, ...]
    arcs: Tuple[Optional[int], ...]


def lambda_list_of(answer, is_exact):
    directions, arcs = answer
    position = _exact.fractions if is_exact else tuple
    return LambdaList(
        tuple(Direction(limit, position(place), is_vector) for limit, place, is_vector in directions), tuple(arcs)
    )
