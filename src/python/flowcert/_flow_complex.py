"""The class that a user holds."""

import operator
from fractions import Fraction
from html import escape
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, _exact, _judge
from ._balls import length
from ._cycles import Cycle, Loop, cycle_of, edges_of
from ._exports import to_meshio, to_pyvista, to_trimesh
from ._limits import LambdaList, lambda_list_of
from ._manifolds import Lines, Mesh, Surfaces
from ._orbit import Orbit, Position, orbit_of
from ._page import show
from ._plots import plot_barcode, plot_diagram
from ._pockets import Places, Pockets, pockets_of
from ._points import point_rows, shown, thread_count
from ._selection import asked
from ._unstable import UnstableSurface, unstable_surface_of

_KINDS = ((1, 2), (1, 3), (2, 3))


class FlowComplex:
    """The flow complex of points: critical points, persistence, surfaces, lines, orbits and cells, exactly.

    FlowComplex(points, *, threads=None, unlimited=False)

    points: (n, 3), any number of rows, none as well; an array, or anything that NumPy makes one of. Repeated rows are
    merged. Coordinates are taken as the doubles that they are. Other floats and integers are converted exactly, and a
    number that is no double is refused, as are NaN and infinities (ValueError).

    threads: how many compute; all cores without it. The results are the same to the bit for any number.

    unlimited: compute points with more than a hundred Delaunay cells each, and two million, too, instead of raising
    ValueError. Points on two skew lines have as many as pairs of points, and take memory and time by that.

    What is copied: the complex keeps the points in memory of its own, 32 bytes a row, so the array may change
    afterwards. An array of doubles in C order is read where it is; for any other a converted copy is made first, and
    given up at once. Arrays that are handed out are no copies either. stationary_points and contacts are kept, so they
    cannot be written to; all others are the caller's.

    What is computed when: nothing at first. Each part is computed when it is first asked for, and kept. Meanwhile
    other threads of Python run, and they may ask the same complex. Ctrl-C stops it soon, but for the chain complex,
    the pairs, volumes, λ-lists and unstable surfaces.

    Stationary points are named by their places in stationary_points, of which critical_points is the first part.
    Points are named by their rows; a repeated one by the first of its rows.

    >>> fc = FlowComplex([[0, 0, 0], [2, 0, 0], [0, 2, 0]])
    >>> fc.critical_points["index"]
    array([0, 0, 0, 1, 1], dtype=int8)
    >>> fc.regular_points["kind"].tolist()  # of the right angle: indices 1 and 2 collide
    [[1, 2]]
    """

    def __init__(self, points: ArrayLike, *, threads: Optional[int] = None, unlimited: bool = False) -> None:
        threads = thread_count(threads)
        self._core = _core.Complex(point_rows(points), threads, bool(unlimited))
        self._unlimited = bool(unlimited)
        self._stationary: Optional[Tuple[NDArray[Any], NDArray[np.int64]]] = None

    # ---- Points

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 3): the points as they were given, repeated rows as well; a new array. -0.0 has become 0.0."""
        return self._core.points()

    @property
    def merged_duplicates(self) -> int:
        """How many rows repeat another."""
        return self._core.merged_duplicates

    @property
    def threads(self) -> int:
        """How many threads compute."""
        return self._core.threads

    # ---- Stationary points

    @property
    def stationary_points(self) -> NDArray[Any]:
        """All stationary points: critical ones by index, then regular ones by kind. A structured array:

        index             int8, 0 to 3, or -1 for a regular stationary point, which has none
        kind              (2,) int8: (i, i) if it is critical of index i. A regular point is (1, 2), (1, 3) or (2, 3):
                          a limit case, in which critical points of these indices (of 1, 2, 2, 3 for (1, 3)) collide
        center            (3,) float64, its place, in the unit of the points; the doubles nearest to the exact one
        squared_distance  float64, to the nearest points; in the square of the unit
        contact_offsets   (2,) int64: the nearest points are contacts[first:last]

        A number that would overflow is infinite; exact() has it.
        """
        return self._lists()[0]

    @property
    def critical_points(self) -> NDArray[Any]:
        """The critical points, by index, then by contact set: the first part of stationary_points.

        >>> fc = FlowComplex([[0, 0, 0], [2, 0, 0]])
        >>> fc.critical_points["center"].tolist()
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
        >>> first, last = fc.critical_points["contact_offsets"][2]
        >>> fc.contacts[first:last].tolist()
        [0, 1]
        """
        return self.stationary_points[: sum(self.counts)]

    @property
    def regular_points(self) -> NDArray[Any]:
        """The regular stationary points, the last part of stationary_points. Usually there are none."""
        return self.stationary_points[sum(self.counts) :]

    @property
    def contacts(self) -> NDArray[np.int64]:
        """Rows of the points: the contact sets of all stationary points, one after the other, each ascending.

        contact_offsets says which part belongs to which stationary point.
        """
        return self._lists()[1]

    @property
    def counts(self) -> Tuple[int, int, int, int]:
        """How many critical points of index 0, 1, 2 and 3 there are."""
        minima, one, two, maxima = self._core.critical_counts()
        return minima, one, two, maxima

    @property
    def regular_counts(self) -> Dict[Tuple[int, int], int]:
        """How many regular stationary points of each kind there are."""
        return dict(zip(_KINDS, self._core.regular_counts()))

    @property
    def euler_sum(self) -> int:
        """The counts, added with alternating signs: 1, or 0 without points."""
        return self._core.euler_sum()

    def exact(self, i: int) -> Tuple[Position, Fraction]:
        """The exact center (three Fractions) and squared distance (a Fraction) of stationary point i.

        >>> FlowComplex([[0, 0, 0], [1, 0, 0]]).exact(2)
        ((Fraction(1, 2), Fraction(0, 1), Fraction(0, 1)), Fraction(1, 4))
        """
        center, squared_distance = self._core.exact(self._place(i))
        return _exact.fractions(center), _exact.fraction(squared_distance)

    # ---- Persistence

    def persistence(
        self, *, zero: bool = False, dimension: Optional[int] = None, squared: bool = True
    ) -> Union[List[Tuple[int, Tuple[float, float]]], NDArray[np.float64]]:
        """The persistence pairs of the squared distance function, in GUDHI's form: [(dimension, (birth, death)), ...].

        They are those of the alpha complex, exactly. Birth and death are squared distances (the square of the unit),
        as GUDHI's alpha complex has them; the death of what lasts is math.inf. They come by dimension, then birth, then
        death. gudhi.plot_persistence_diagram and its siblings take the list.

        zero: the regular stationary points as well, as pairs of length zero.
        dimension: the intervals of this dimension alone, as an (n, 2) array of births and deaths. The points that make
        them are in persistence_pairs(dimension=...), in the same order.
        squared: False for distances that are not squared, the nearest doubles to the roots.

        >>> fc = FlowComplex([[0, 0, 0], [4, 0, 0]])
        >>> fc.persistence()
        [(0, (0.0, 4.0)), (0, (0.0, inf))]
        >>> fc.persistence(dimension=0, squared=False)
        array([[ 0.,  2.],
               [ 0., inf]])
        """
        if dimension is None:
            return self._core.persistence(bool(zero), bool(squared))
        pairs = self._pairs(zero, dimension, squared)
        return np.column_stack([pairs["birth"], pairs["death"]])

    def _pairs(self, zero: bool, dimension: Optional[int], squared: bool) -> NDArray[Any]:
        pairs = self._core.pairs(bool(zero), bool(squared))
        if dimension is None:
            return pairs
        if operator.index(dimension) not in (0, 1, 2):
            raise ValueError("dimension must be 0, 1 or 2")
        return pairs[pairs["dimension"] == dimension]

    def persistence_pairs(
        self, *, zero: bool = False, dimension: Optional[int] = None, squared: bool = True
    ) -> NDArray[Any]:
        """The same pairs in the same order as a structured array, with the points that make them:

        dimension     int8, 0 to 2
        birth, death  float64, squared distances; math.inf
        birth_point   int64, a place in stationary_points
        death_point   int64, a place in stationary_points; -1 where it lasts

        zero, dimension, squared: as in persistence.
        """
        return self._pairs(zero, dimension, squared)

    # ---- What flows from and to saddles

    def stable_surfaces(self) -> Surfaces:
        """The stable manifolds of all critical points of index 2, as triangles: (vertices, faces, saddles,
        squared_distances). They are disks that the saddles' Gabriel edges bound. Parts of dimension 3, which degenerate
        inputs may have, are left out.
        """
        return Surfaces(*self._core.surface([]))

    def surface(self, select: Union[str, Iterable[str], None] = None) -> Mesh:
        """The stable manifolds of chosen critical points of index 2, as one surface: (vertices, faces).

        select: an expression, or several that all have to hold, as `flowcert surface --select` takes them; all without
        it. For example:

        "index2-radius<R"   the circle through the nearest points has a radius below R, in the unit of the points
        "persistence>X"     the point's pair is longer than X, a difference of distances, in the unit of the points
        "largest-gaps=N"    the N most persistent ones

        R and X are decimals or fractions, as 0.1 and 1/3. Instead of R and X there may be:

        "1.6spacing"        that many times the median distance of a point to its nearest other point
        "q0.9"              a quantile, from q0 to q1: below it are 90 % of all radii, or above it 10 % of the lengths
        "auto"              the valley of their histogram: no number has to be chosen

        "index2-radius<R" with R a few times the distance of neighbours reconstructs the shape that the points are
        samples of. If they are dense, "auto" often finds such an R, but the surface may have holes.
        """
        return Mesh(*asked(self._core.surface, select)[:2])

    def unstable_lines(self) -> Lines:
        """The unstable manifolds of all critical points of index 2, two lines each: (vertices, offsets, saddles,
        limits, squared_distances).
        """
        return Lines(*self._core.unstable_lines())

    def orbit(self, start: Iterable[Any]) -> Orbit:
        """Where the flow takes a position, segment by segment, exactly.

        start: three numbers in the unit of the points; floats are taken as the doubles that they are, and Fractions as
        they are.

        >>> FlowComplex([[0, 0, 0], [2, 0, 0]]).orbit([0.5, 0, 0]).limit.position
        (Fraction(1, 1), Fraction(0, 1), Fraction(0, 1))
        """
        try:
            start = tuple(_exact.exact(value, "start") for value in start)
        except TypeError:
            raise ValueError("start must be three numbers") from None
        if len(start) != 3:
            raise ValueError(f"start must be three numbers, not {len(start)}")
        return orbit_of(start, self._core.orbit([_exact.hexadecimal(value) for value in start]))

    def locate(self, positions: ArrayLike) -> Places:
        """Where the flow takes many positions, and their nearest points: (limits, nearest, tied).

        positions: (n, 3), as the points of a FlowComplex. The first call prepares what all of them need.

        >>> fc = FlowComplex([[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [1, 1, 3]])
        >>> limits, nearest, tied = fc.locate([[0.5, 1, 0.5], [9, 9, 9], [1, 0, 0]])
        >>> limits.tolist(), nearest.tolist(), tied.tolist()
        ([18, -1, 5], [0, 4, 0], [True, False, True])
        """
        return Places(*self._core.locate(point_rows(positions)))

    def pockets(self, persistence: Any = "auto", *, probe: Any = None) -> Pockets:
        """Pockets: what flows to the same maxima, merged by persistence, with their mouths. Distances are measured to
        the points, which have no radii: of atoms, to their centres. flowcert.cavities has rooms between balls.

        persistence: pockets are deeper than this, a difference of distances; what is not is merged, and 0 merges
        nothing. A number; or a str, as `flowcert pockets --persistence` takes it: "3spacing", "q0.9" or "auto", which
        is the valley of all depths, or else half the spacing.
        probe: a radius. If it is given, each pocket has a kind: "cavity" if no path to infinity keeps this distance
        from all points, "channel" if several of its mouths are as wide, and "pocket" if one is.

        >>> fc = FlowComplex([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
        >>> [pocket] = fc.pockets(0, probe=0.8).pockets
        >>> pocket.volume, pocket.difference_of_squares, len(pocket.mouths), pocket.kind
        (1.3333333333333333, Fraction(1, 3), 8, 'channel')
        >>> len(fc.pockets(Fraction(1, 5)).pockets)
        0
        """
        radius = None if probe is None else _exact.hexadecimal(length(probe, "probe"))
        return pockets_of(self._core.pockets(_exact.words(persistence, "persistence"), radius))

    def cycles(
        self,
        dimension: int = 1,
        *,
        longest: int = 10,
        level: Any = "25%",
        persistence: Any = None,
        pair: Optional[Tuple[int, int]] = None,
    ) -> List[Cycle]:
        """What persistence pairs stand for, from the longest pair down: a list of Loop for dimension 1, of Void for
        dimension 2, or of Joined for dimension 0. A class that lasts is none of them.

        longest: so many pairs. persistence: instead, all that are longer than this, a difference of distances; a
        number, or a str as `flowcert cycles --persistence` takes it. pair: instead, this one, (birth, death), places in
        critical_points.
        level: where between birth and death. "25%", a share of the way, in squared distances; a number, a distance, for
        the pairs that are there at it; "birth"; or "death", for the death point's own stable manifold alone.

        >>> square = FlowComplex([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
        >>> [loop] = square.cycles()
        >>> loop.polygons[0].tolist(), loop.loop_length, loop.squared_level, len(loop.surface.faces)
        ([0, 1, 2, 3], 8.0, Fraction(5, 4), 8)
        >>> octahedron = FlowComplex([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
        >>> [void] = octahedron.cycles(dimension=2)
        >>> void.volume, len(void.walls)
        (1.3333333333333333, 8)
        """
        if dimension not in (0, 1, 2):
            raise ValueError(f"dimension: not 0, 1 or 2, but {dimension!r}")
        if longest < 0:
            raise ValueError("longest: less than 0")
        names = None if pair is None else tuple(self._contact(place) for place in pair)
        return [
            cycle_of(self, dimension, cycle)
            for cycle in self._core.cycles(
                dimension,
                longest,
                None if persistence is None else _exact.words(persistence, "persistence"),
                names,
                _exact.words(level, "level"),
            )
        ]

    def represents(self, loops: Sequence[Any], pair: Tuple[int, int], squared_level: Any = None) -> bool:
        """Whether loops, from here or from any other program, are a basis of what stands for pairs of dimension 1: at
        the birth of `pair`, for all pairs with its birth and death; at another level, for all that are born up to there
        and have its death. One loop is one, of a pair that is alone.

        loops: each is a Loop, the rows of a closed polygon, a list of several, or edges, (k, 2) rows. An edge may join
        any two points.
        pair: (birth, death), places in critical_points.
        squared_level: a number, the square of a distance. If it is not given, it is the greatest level of the loops
        that are Loop, or else the birth.

        >>> square = FlowComplex([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
        >>> square.represents([[0, 1, 2, 3]], (7, 8)), square.represents([[0, 1, 2]], (7, 8))
        (True, False)
        """
        levels = [loop.squared_level for loop in loops if isinstance(loop, Loop)]
        if squared_level is None and levels:
            squared_level = max(levels)
        level = None if squared_level is None else _exact.hexadecimal(_exact.exact(squared_level, "squared_level"))
        return self._core.represents(
            [edges_of(loop) for loop in loops], self._place(pair[0]), self._place(pair[1]), level
        )

    def homologous(self, loop: Any, other: Any, squared_level: Any) -> bool:
        """Whether two loops lie among the balls of a level around all points, and one can be deformed into the other
        there: their sum bounds (mod 2). False, too, if one of them is no cycle, or leaves the balls. An edge pq is
        among them if |p-q| is at most twice their radius.

        loop, other: as in represents(). [] is the loop that bounds.
        squared_level: a number, the square of this radius.

        >>> square = FlowComplex([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
        >>> square.homologous([0, 1, 2, 3], [], 1), square.homologous([0, 1, 2, 3], [], 2)
        (False, True)
        """
        level = _exact.hexadecimal(_exact.exact(squared_level, "squared_level"))
        return self._core.homologous(edges_of(loop), edges_of(other), level)

    def _contact(self, i: int) -> List[int]:
        place, points = self._place(i), self.stationary_points
        if place >= len(points):
            raise ValueError(f"there is no stationary point {place}; there are {len(points)}")
        begin, end = points[place]["contact_offsets"]
        return self.contacts[begin:end].tolist()

    # ---- The whole complex: cells and their volumes, connections

    @property
    def volumes(self) -> NDArray[np.float64]:
        """The volumes of the stable manifolds of all stationary points, in the cube of the unit: the nearest doubles.

        (k,) float64, in the order of stationary_points; a new array. It is 0 where the manifold has no part of
        dimension 3, as for minima and nearly all saddles. A number that would overflow is infinite; volume() has it.

        >>> fc = FlowComplex([[0, 5, 0], [-3, 0, -2], [3, 0, -2], [0, 0, 12], [0, -5, 0]])
        >>> [(int(fc.stationary_points["index"][i]), float(fc.volumes[i])) for i in fc.volumes.nonzero()[0]]
        [(2, 50.0), (3, 45.0), (3, 45.0)]
        """
        return self._core.volumes()

    def volume(self, i: int) -> Fraction:
        """The exact volume of the stable manifold of stationary point i, in the cube of the unit.

        It takes time where a scan's numbers become long.

        >>> fc = FlowComplex([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [2, 1, 1]])
        >>> [fc.volume(i) for i in fc.volumes.nonzero()[0]]
        [Fraction(1, 6), Fraction(1, 6)]
        """
        return _exact.fraction(self._core.volume(self._place(i)))

    def shares(self, i: int, *, exact: bool = False) -> Union[Dict[int, float], Dict[int, Fraction]]:
        """How much of volume(i) lies in the Voronoi cells of which points: {row: volume}, by ascending row.

        The volumes are positive; the exact ones add up to volume(i).
        exact: volumes are Fractions instead of the nearest doubles, which are there much sooner for a scan.

        >>> fc = FlowComplex([[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [1, 1, 3]])
        >>> [i] = fc.volumes.nonzero()[0]
        >>> {row: str(volume) for row, volume in fc.shares(i, exact=True).items()}
        {0: '599/720', 1: '599/720', 2: '599/720', 3: '599/720', 4: '121/180'}
        >>> fc.shares(i)[4]
        0.6722222222222223
        """
        place = self._place(i)
        if not exact:
            return dict(self._core.shares(place, False))
        return {row: _exact.fraction(volume) for row, volume in self._core.shares(place, True)}

    @property
    def hull_volume(self) -> Fraction:
        """The exact volume of the convex hull of the points, in the cube of the unit.

        What the volumes of all stationary points leave of it flows to infinity.
        """
        return _exact.fraction(self._core.hull_volume())

    def lambda_list(self, i: int, *, exact: bool = False) -> LambdaList:
        """Where the directions of stationary point i lead: of a regular one, or of a saddle, of index 1 or 2.

        exact: positions are Fractions instead of the nearest doubles.

        >>> fc = FlowComplex([[0, 0, 0], [6, 0, 0], [2, 4, 0]])
        >>> fc.lambda_list(3).arcs, fc.lambda_list(3).directions
        ((None,), (Direction(limit=6, exit=(3.0, 1.0, 0.0), is_vector=False),))
        """
        place = self._place(i)
        answer = self._core.lambda_list(place, bool(exact))
        if answer is None:
            raise ValueError(f"stationary point {place} has no list of limits; saddles and regular points have one")
        return lambda_list_of(answer, exact)

    def unstable_surface(self, i: int, *, exact: bool = False) -> UnstableSurface:
        """All that flows from stationary point i, as a set: of an index-1 point, or a regular one of kind (1, 2) or
        (1, 3). It has dimension 2, and can be large.

        exact: positions are Fractions instead of the nearest doubles.

        >>> fc = FlowComplex([[-4, 0, 0], [4, 0, 0], [0, 1, 0]])
        >>> [sheet.samples for sheet in fc.unstable_surface(3).sheets]
        [(0, 1), (0, 2)]
        >>> [[corner.position for corner in trace.ends] for trace in fc.unstable_surface(3).traces]
        [[(0.0, 0.0, -1.0), (0.0, 0.0, 1.0)]]
        """
        place = self._place(i)
        answer = self._core.unstable_surface(place, bool(exact))
        if answer is None:
            raise ValueError(
                f"stationary point {place} has no unstable surface; those of index 1, and of the kinds 1-2 and 1-3, "
                "have one"
            )
        return unstable_surface_of(answer, exact)

    @property
    def connections(self) -> NDArray[Any]:
        """Which stationary points lead to which others, or to infinity. A structured array, by from, then to:

        from      int64, a place in stationary_points, of a saddle or of a regular point
        to        int64, a place in stationary_points; -1 for infinity, which comes last
        orbits    int64, how many isolated directions lead there: single ones beside no arc of their own limit
        families  int64, how many arcs of directions do

        >>> FlowComplex([[0, 0, 0], [6, 0, 0], [2, 4, 0]]).connections.tolist()[:3]
        [(3, 6, 1, 0), (3, -1, 0, 1), (4, 6, 1, 0)]
        """
        return self._core.connections()

    @property
    def is_morse_smale(self) -> bool:
        """Whether no stationary point is regular, no index-2 point has a stable manifold with a part of dimension 3,
        and everything that flows from index-2 points ends at maxima or at infinity.
        """
        return self._core.is_morse_smale()

    def check(self, claim: Any, **options: Any) -> _judge.CheckReport:
        """Whether a claim about these points is right: flowcert.check(points, claim), which says more."""
        return _judge.check(self._core, claim, **options)

    def _place(self, i: int) -> int:
        """As the library takes it, which says the rest of what is wrong."""
        place = operator.index(i)
        if not 0 <= place < 2**63:
            count = sum(self.counts) + sum(self.regular_counts.values())
            raise ValueError(f"there is no stationary point {shown(place)}; there are {count}")
        return place

    # ---- For people and other libraries. Modules of their own have what these do.

    show = show
    plot_diagram = plot_diagram
    plot_barcode = plot_barcode
    to_pyvista = to_pyvista
    to_trimesh = to_trimesh
    to_meshio = to_meshio

    # ---- What Python asks

    def _lists(self) -> Tuple[NDArray[Any], NDArray[np.int64]]:
        if self._stationary is None:
            self._stationary = self._core.stationary_points()
        return self._stationary

    def __reduce__(self) -> Tuple[Any, ...]:
        return _made, (self.points, self.threads, self._unlimited)

    def __repr__(self) -> str:
        return f"<flowcert.FlowComplex of {self._core.row_count:,} points>"

    def _repr_html_(self) -> str:
        """The counts as a table, for notebooks. Computes the critical points, if need be."""
        names = ("minima: the points themselves", "saddles on Gabriel edges", "saddles on Delaunay facets", "maxima")
        rows = [("points", self._core.row_count, ""), ("merged duplicates", self.merged_duplicates, "")]
        rows += [
            (f"critical points of index {index}", count, names[index]) for index, count in enumerate(self.counts)
        ]
        rows += [
            (f"regular stationary points {face}-{hull}", count, "")
            for (face, hull), count in self.regular_counts.items()
        ]
        rows.append(("Euler sum", self.euler_sum, ""))
        cells = "".join(
            f'<tr><th scope="row" style="text-align:left">{escape(name)}</th>'
            f'<td style="text-align:right">{number:,}</td><td style="text-align:left">{escape(note)}</td></tr>'
            for name, number, note in rows
        )
        return f"<table><caption>flowcert.FlowComplex</caption><tbody>{cells}</tbody></table>"


def _made(points: NDArray[np.float64], threads: int, unlimited: bool) -> FlowComplex:
    """What pickle calls, which takes no names of arguments."""
    return FlowComplex(points, threads=threads, unlimited=unlimited)
