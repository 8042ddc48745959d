"""What flows from and to saddles, as arrays."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Mesh(NamedTuple):
    """A surface of triangles: ``vertices, faces = fc.surface(...)``.

    vertices  (m, 3) float64, in the unit of the points; the doubles nearest to the exact positions
    faces     (k, 3) int32, places in vertices. Triangles share a vertex iff their exact positions are equal.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]


class Surfaces(NamedTuple):
    """The stable manifolds of all critical points of index 2, as triangles.

    vertices           (m, 3) float64, in the unit of the points
    faces              (k, 3) int32, places in vertices
    saddles            (k,) int64, for each face its saddle, a place in critical_points
    squared_distances  (m,) float64, from each vertex to the nearest points; infinite where it is beyond the doubles
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    saddles: NDArray[np.int64]
    squared_distances: NDArray[np.float64]


class Lines(NamedTuple):
    """The unstable manifolds of all critical points of index 2: two lines each.

    vertices           (m, 3) float64, in the unit of the points. A line to infinity ends at its last finite vertex,
                       which may be far away.
    offsets            (k + 1,) int64; line i is vertices[offsets[i]:offsets[i + 1]], from its saddle on
    saddles            (k,) int64, for each line its saddle, a place in critical_points; side 0 comes before side 1
    limits             (k,) int64, where each line ends, a place in stationary_points; -1 for infinity
    squared_distances  (m,) float64, from each vertex to the nearest points
    """

    vertices: NDArray[np.float64]
    offsets: NDArray[np.int64]
    saddles: NDArray[np.int64]
    limits: NDArray[np.int64]
    squared_distances: NDArray[np.float64]
