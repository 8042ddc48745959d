"""What the files of `flowcert compute --export` have, as data sets of other libraries.

Each library is imported when it is asked for, and need not be there otherwise.
"""

from typing import TYPE_CHECKING, Any, Dict, Iterable, List, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _balls, _exact
from ._selection import asked

if TYPE_CHECKING:
    from ._flow_complex import FlowComplex

_PARTS = (
    "critical_points", "stable_surfaces", "unstable_lines", "unstable_fans", "unstable_surfaces", "stable_cells",
    "infinity_cells",
)  # fmt: skip
_TETRAHEDRON, _PYRAMID = 10, 14  # VTK's numbers
_Arrays = Dict[str, NDArray[Any]]


class _Cells(NamedTuple):
    """Points of all cells, one cell after the other, and where each cell ends."""

    connectivity: NDArray[np.int64]
    offsets: NDArray[np.int64]

    @property
    def sizes(self) -> NDArray[np.int64]:
        return np.diff(self.offsets, prepend=0)

    def of_size(self, size: int) -> Tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The cells of so many points as rows, and their places."""
        places = np.flatnonzero(self.sizes == size)
        return self.connectivity[(self.offsets[places] - size)[:, None] + np.arange(size)], places

    def padded(self) -> NDArray[np.int64]:
        """Each cell behind its size, as VTK's older arrays have it."""
        return np.insert(self.connectivity, self.offsets - self.sizes, self.sizes)

    def steps(self) -> Tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Each two points that follow each other in a cell, and the places of these cells."""
        count = len(self.connectivity)
        ahead = np.setdiff1d(np.arange(count), self.offsets - 1)
        pairs = self.connectivity[ahead[:, None] + [0, 1]] if count else np.empty((0, 2), np.int64)
        return pairs, np.repeat(np.arange(len(self.offsets)), self.sizes - 1)

    def triangles(self) -> Tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The fans of polygons, from their first corners, and the places of these polygons."""
        fans = np.maximum(self.sizes - 2, 0)
        places = np.repeat(np.arange(len(self.offsets)), fans)
        first = (self.offsets - self.sizes)[places]
        second = first + 1 + np.arange(len(places)) - np.repeat(np.cumsum(fans) - fans, fans)
        return self.connectivity[np.column_stack([first, second, second + 1])], places


class _DataSet(NamedTuple):
    """cells: vertices, lines and polygons, without shapes; or cells of dimension 3, with VTK's number of each."""

    points: NDArray[np.float64]
    cells: List[_Cells]
    shapes: Optional[NDArray[np.uint8]]
    point_data: _Arrays
    cell_data: _Arrays


def _data_set(fc: "FlowComplex", part: str, select: Union[str, Iterable[str], None], clip: Any) -> _DataSet:
    if part not in _PARTS:
        raise ValueError(f"part: there is no {part!r}; there are {', '.join(_PARTS)}")
    if select is not None and part != "stable_surfaces":
        raise ValueError(f"select: for stable_surfaces alone, not for {part}")
    factor = None if clip is None else _balls.number(clip, "clip")
    if factor is not None and factor < 1:
        raise ValueError("clip must be a number from 1, or None")
    box = None if factor is None else _exact.hexadecimal(factor)
    points, cells, *more = asked(lambda expressions: fc._core.exported(part, expressions, box), select)
    return _DataSet(points, [_Cells(*some) for some in cells], *more)


def to_pyvista(
    self: "FlowComplex", part: str = "stable_surfaces", *, select: Union[str, Iterable[str], None] = None, clip: Any = 3
) -> Any:
    """A part of the complex as a data set of PyVista, which has to be there.

    part: the name of a file of `flowcert compute --export`, with the same cells and the same arrays (the manual of the
    exports says what they mean). A pyvista.PolyData:

    "critical_points"    all stationary points, critical or regular, as vertices
    "stable_surfaces"    the stable manifolds of critical points of index 2, as triangles
    "unstable_lines"     what flows from critical points of index 2: two lines each
    "unstable_fans"      what flows from critical points of index 1, in their own Voronoi facets: triangles
    "unstable_surfaces"  all that flows from critical points of index 1: polygons, and lines where it is thin

    or a pyvista.UnstructuredGrid, of tetrahedra and pyramids:

    "stable_cells"       what flows to maxima; the array `maximum` says to which
    "infinity_cells"     what flows to infinity

    Regular stationary points come with critical points of their dimension.
    select: of stable_surfaces, as surface() takes it. "index2-radius<3spacing" may be the shape of a scan.
    clip: what goes to infinity ends at the bounding box of the points, made larger by this factor, from 1 on; None cuts
    nothing, and leaves out what has no end.

    >>> fc = FlowComplex([[0, 0, 0], [6, 0, 0], [2, 4, 0]])
    >>> fc.to_pyvista("unstable_lines").n_lines  # doctest: +SKIP
    2
    """
    import pyvista

    data = _data_set(self, part, select, clip)
    if data.shapes is None:
        made = pyvista.PolyData()
        made.points = data.points
        made.verts, made.lines, made.faces = (cells.padded() for cells in data.cells)
    elif len(data.shapes):
        made = pyvista.UnstructuredGrid(data.cells[0].padded(), data.shapes, data.points)
    else:
        made = pyvista.UnstructuredGrid()
    for name, values in data.point_data.items():
        made.point_data[name] = values
    for name, values in data.cell_data.items():
        made.cell_data[name] = values
    return made


def to_meshio(
    self: "FlowComplex", part: str = "stable_surfaces", *, select: Union[str, Iterable[str], None] = None, clip: Any = 3
) -> Any:
    """A part of the complex as a meshio.Mesh, which writes many formats. meshio has to be there.

    part, select, clip: as to_pyvista() takes them. A line of several points is as many pieces, each with the arrays of
    its line. Polygons are together where they have as many corners.

    >>> fc = FlowComplex([[0, 0, 0], [6, 0, 0], [2, 4, 0]])
    >>> fc.to_meshio().write("surfaces.vtu")  # doctest: +SKIP
    """
    import meshio

    data = _data_set(self, part, select, clip)
    blocks: List[Tuple[str, NDArray[np.int64], NDArray[np.int64]]] = []  # of which rows of cell_data
    if data.shapes is None:
        vertices, lines, polygons = data.cells
        blocks.append(("vertex", *vertices.of_size(1)))
        steps, places = lines.steps()
        blocks.append(("line", steps, places + len(vertices.offsets)))
        for size in np.unique(polygons.sizes).tolist():
            rows, places = polygons.of_size(size)
            name = {3: "triangle", 4: "quad"}.get(size, "polygon")
            blocks.append((name, rows, places + len(vertices.offsets) + len(lines.offsets)))
    else:
        blocks += [("tetra", *data.cells[0].of_size(4)), ("pyramid", *data.cells[0].of_size(5))]
    blocks = [block for block in blocks if len(block[1])]
    cell_data = {name: [values[places] for _, _, places in blocks] for name, values in data.cell_data.items()}
    return meshio.Mesh(data.points, [block[:2] for block in blocks], data.point_data, cell_data)


def to_trimesh(
    self: "FlowComplex", part: str = "stable_surfaces", *, select: Union[str, Iterable[str], None] = None, clip: Any = 3
) -> Any:
    """A part of the complex for trimesh, which has to be there.

    part, select, clip: as to_pyvista() takes them. Of "stable_surfaces", "unstable_fans" and "unstable_surfaces" a
    trimesh.Trimesh, of "unstable_lines" a trimesh.path.Path3D, and of "critical_points" a trimesh.PointCloud. The
    arrays are in vertex_attributes and face_attributes of a Trimesh, and in metadata of the others. A polygon is a fan
    of triangles, and of unstable_surfaces there are polygons alone. trimesh has no cells of dimension 3.

    >>> fc = FlowComplex([[0, 0, 0], [6, 0, 0], [2, 4, 0]])
    >>> float(fc.to_trimesh().area)  # doctest: +SKIP
    12.0
    """
    import trimesh

    data = _data_set(self, part, select, clip)
    if data.shapes is not None:
        raise ValueError(f"trimesh has no cells of dimension 3; to_pyvista() and to_meshio() have {part}")
    vertices, lines, polygons = data.cells
    if part == "critical_points":
        return trimesh.PointCloud(data.points, metadata=data.point_data)
    if part == "unstable_lines":
        from trimesh.path import Path3D, entities

        parts = np.split(lines.connectivity, lines.offsets[:-1]) if len(lines.offsets) else []
        arrays = {name: values[len(vertices.offsets) :] for name, values in data.cell_data.items()}
        made = [entities.Line(part) for part in parts]
        return Path3D(made, data.points, metadata={**data.point_data, **arrays}, process=False)
    faces, places = polygons.triangles()
    places = places + len(vertices.offsets) + len(lines.offsets)
    return trimesh.Trimesh(
        data.points, faces, process=False, vertex_attributes=data.point_data,
        face_attributes={name: values[places] for name, values in data.cell_data.items()},
    )  # fmt: skip
