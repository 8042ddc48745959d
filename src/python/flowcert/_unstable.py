"""The unstable sets of dimension 2, as sets."""

from dataclasses import dataclass
from typing import Tuple, Union

from . import _exact
from ._orbit import Position

_Place = Union[Tuple[float, float, float], Position]


@dataclass(frozen=True)
class SurfaceCorner:
    """A point, or an end at infinity.

    position   in the unit of the points; the nearest doubles, of which one is infinite where it would overflow, or
               Fractions
    is_vector  whether it is at infinity; then position is a vector to it, whose greatest coordinate is 1 or -1
    """

    position: _Place
    is_vector: bool


@dataclass(frozen=True)
class UnstableInterval:
    """A part of a Voronoi edge.

    polygon  a tuple of rows, the nearest points of the edge
    ends     two of SurfaceCorner, the lesser one first; equal where the part is one point
    """

    polygon: Tuple[int, ...]
    ends: Tuple[SurfaceCorner, SurfaceCorner]


@dataclass(frozen=True)
class UnstableSheet:
    """A part of dimension 2 of the Voronoi facet of two points: a convex polygon, with its sides.

    samples  two rows
    corners  a tuple of SurfaceCorner, in cyclic order; empty if the sheet is the whole facet because all points lie in
             one plane
    """

    samples: Tuple[int, int]
    corners: Tuple[SurfaceCorner, ...]


@dataclass(frozen=True)
class UnstableSegment:
    """An open segment, in which a single ray crosses the Voronoi facet of two points.

    samples  two rows
    start    where the ray enters the facet, a position as in SurfaceCorner
    end      a SurfaceCorner, where it leaves the facet
    """

    samples: Tuple[int, int]
    start: _Place
    end: SurfaceCorner


@dataclass(frozen=True)
class UnstableSurface:
    """All that flows from an index-1 point, or from a regular one of kind (1, 2) or (1, 3), as a set.

    Its parts lie on Voronoi vertices, edges and facets, and do not meet. No part counts twice.

    vertices  a tuple of positions as in SurfaceCorner: the Voronoi vertices that belong to it
    traces    a tuple of UnstableInterval, where it comes to Voronoi edges through facets; each with those of its ends
              that are on the edge
    runs      a tuple of UnstableInterval, without their ends: the rest of it on Voronoi edges
    sheets    a tuple of UnstableSheet, one of which has the point itself
    segments  a tuple of UnstableSegment
    """

    vertices: Tuple[_Place, ...]
    traces: Tuple[UnstableInterval, ...]
    runs: Tuple[UnstableInterval, ...]
    sheets: Tuple[UnstableSheet, ...]
    segments: Tuple[UnstableSegment, ...]


def unstable_surface_of(answer, is_exact):
    position = _exact.fractions if is_exact else tuple

    def corner(made):
        return SurfaceCorner(position(made[0]), made[1])

    def intervals(parts):
        return tuple(UnstableInterval(tuple(polygon), (corner(a), corner(b))) for polygon, (a, b) in parts)

    vertices, traces, runs, sheets, segments = answer
    return UnstableSurface(
        tuple(map(position, vertices)),
        intervals(traces),
        intervals(runs),
        tuple(UnstableSheet(tuple(samples), tuple(map(corner, corners))) for samples, corners in sheets),
        tuple(UnstableSegment(tuple(samples), position(start), corner(end)) for samples, start, end in segments),
    )
