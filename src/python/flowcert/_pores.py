"""Rooms between balls, as atoms with radii are."""

import operator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _balls, _core, _exact
from ._page import show_pores
from ._points import shown, thread_count
from ._quadratic_number import QuadraticNumber


@dataclass(frozen=True, eq=False)
class Chamber:
    """A room apart, from its gate up to its peak. Places are those of Pores.points, ascending.

    peaks     int64 array, where it is widest
    gates     int64 array, where it becomes part of a room at least as wide; none if its gate is below 0
    windows   int64 array, places in Pores.windows: the narrowest places of the ways out of it
    handles   int64 array, narrow places that have this room at both sides
    peak      QuadraticNumber, the radius of the widest probe that has room in it
    gate      QuadraticNumber, the radius of the widest probe that can leave it; None if it is below 0
    exit      QuadraticNumber, the radius of the widest probe that can get to the outside; None if it is below 0
    depth     float, the peak less the gate; the nearest double
    """

    peaks: NDArray[np.int64]
    gates: NDArray[np.int64]
    windows: NDArray[np.int64]
    handles: NDArray[np.int64]
    peak: QuadraticNumber
    gate: Optional[QuadraticNumber]
    exit: Optional[QuadraticNumber]
    depth: float

    @property
    def diameter(self) -> float:
        """Twice the peak: the pore diameter of a cage."""
        return self.peak.twice

    @property
    def limiting_diameter(self) -> Optional[float]:
        """Twice the exit. None if it is below 0."""
        return None if self.exit is None else self.exit.twice

    def status(self, probe: Any) -> str:
        """What it is for a probe of this radius: "open", "closed" or "too small". What is equal passes."""
        radius = _balls.length(probe, "probe")
        if self.peak < radius:
            return "too small"
        return "closed" if self.gate is None or self.gate < radius else "open"


@dataclass(frozen=True, eq=False)
class Window:
    """A narrowest place between rooms.

    point  int, its place in Pores.points
    rooms  a tuple of int, the numbers of the rooms that it is between: chambers, then vestibules; -1 is the outside
    value  QuadraticNumber, the radius of the widest probe that passes it
    """

    point: int
    rooms: Tuple[int, ...]
    value: QuadraticNumber

    @property
    def diameter(self) -> float:
        """Twice the value."""
        return self.value.twice


class Pores:
    """The rooms between balls, and how wide the ways out of them are, for probes of all radii: what pores() returns.

    A place is as far from a ball as from its surface, and its value is the radius of the widest probe whose centre can
    be there. Radii and places have the unit of the points. All decisions are exact; a number is a QuadraticNumber or a
    nearest double. The words are those of `flowcert pores`, whose manual says more.

    chambers    a list of Chamber, the deepest first; a chamber's number is its place in it
    windows     a list of Window, the widest first, of chambers and of vestibules
    vestibules  a list of int64 arrays: the places in points where rooms are widest that are no chambers, and open to
                several rooms at one radius; their numbers follow those of the chambers
    cavities    (k, 2) int64, chambers of all depths as places in points: a gate, or -1 if it is below 0, and a peak.
                For a probe of radius s there are as many cavities as rows with gate < s <= peak
    depth       Fraction, that of the chambers, or less
    """

    def __init__(self, rows: List[List[str]], depth: Fraction, threads: int) -> None:
        self._made_of = rows, depth, threads
        self._core = _core.Pores(rows, _exact.hexadecimal(depth), threads)
        self._lists: Optional[Tuple[NDArray[Any], NDArray[np.int64]]] = None
        self.depth = depth
        self.chambers = [self._chamber(k, *places) for k, places in enumerate(self._core.chambers())]
        self.windows = [Window(point, rooms, self._value(point)) for point, rooms in self._core.windows()]
        self.vestibules: List[NDArray[np.int64]] = self._core.vestibules()
        self.cavities: NDArray[np.int64] = self._core.cavities()

    @property
    def hidden(self) -> NDArray[np.int64]:
        """Rows of the balls that are inside of another one, and of equal balls all but the first; int64, ascending."""
        return self._core.hidden()

    @property
    def points(self) -> NDArray[Any]:
        """The critical points of a value of 0 or more, by falling value. A structured array:

        index            int8, 1 to 3; at index 3 there is a peak of a room, at index 2 a gate, a window or a handle
        rank             int64, of its value: equal ones have the same rank, and 0 is that of the greatest
        value            float64, the radius of the widest probe that can be there; the nearest double
        center           (3,) float64, its place; the nearest doubles
        contact_offsets  (2,) int64: the balls that are nearest are contacts[first:last]

        A number that would overflow is infinite; exact() has it.
        """
        return self._arrays()[0]

    @property
    def contacts(self) -> NDArray[np.int64]:
        """Rows of the balls: the contact sets of all points, one after the other, each ascending."""
        return self._arrays()[1]

    def exact(self, i: int) -> Tuple[Tuple[QuadraticNumber, QuadraticNumber, QuadraticNumber], QuadraticNumber]:
        """The exact center and value of point i.

        >>> cage = pores([[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]], radii="1/2")
        >>> (x, y, z), value = cage.exact(0)
        >>> x == y == z == 0, value.polynomial
        (True, (4, 4, -47))
        """
        place, count = operator.index(i), self._core.point_count
        if not 0 <= place < count:
            raise ValueError(f"there is no point {shown(place)}; there are {count}")
        x, y, z = self._core.center(place)
        return (QuadraticNumber(*x), QuadraticNumber(*y), QuadraticNumber(*z)), self._value(place)

    @property
    def largest_cavity_diameter(self) -> Optional[float]:
        """Twice the greatest peak of the chambers. None without one."""
        return max((chamber.diameter for chamber in self.chambers), default=None)

    @property
    def pore_limiting_diameter(self) -> Optional[float]:
        """Twice the greatest exit of the chambers. None without one."""
        exits = (chamber.limiting_diameter for chamber in self.chambers)
        return max((exit for exit in exits if exit is not None), default=None)

    def cavities_at(self, probe: Any) -> int:
        """How many rooms of any depth have a place for a probe of this radius, and no way out for it.

        >>> cage = pores([[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]], radii=1)
        >>> [cage.cavities_at(probe) for probe in ("2.2", "2.4", "2.6")]
        [0, 1, 0]
        """
        return self._core.cavities_at(_exact.hexadecimal(_balls.length(probe, "probe")))

    def cavity_steps(self) -> List[Tuple[QuadraticNumber, int]]:
        """The same for all probes: (up_to, cavities), from the greatest radius down. So many there are for probes
        up to this radius, and above that of the next one, or from 0; for wider probes than the first there is none.
        """
        return [(self._value(point), count) for point, count in self._core.cavity_steps()]

    show = show_pores

    def _value(self, point: int) -> QuadraticNumber:
        return QuadraticNumber(*self._core.value(point))

    def _chamber(self, k, peaks, gates, windows, handles, exit):
        values = [None if place is None else self._value(place) for place in (peaks[0], next(iter(gates), None), exit)]
        return Chamber(peaks, gates, windows, handles, *values, self._core.depth(k))

    def _arrays(self) -> Tuple[NDArray[Any], NDArray[np.int64]]:
        if self._lists is None:
            self._lists = self._core.points()
        return self._lists

    def __reduce__(self) -> Tuple[Any, ...]:
        return Pores, self._made_of

    def __repr__(self) -> str:
        return f"<flowcert.Pores of {self._core.ball_count:,} balls: {len(self.chambers):,} chambers>"


def pores(
    points: Union[ArrayLike, Sequence[Sequence[Any]]], radii: Any, *, depth: Any = Fraction(1, 10),
    threads: Optional[int] = None,
) -> Pores:  # fmt: skip
    """The rooms between atoms with radii: chambers, their gates, exits and windows, for probes of all radii at once.

    points: (n, 3), the centres. radii: one number for all, or n of them, in the same unit, all above 0. A float is the
    double that it is; a str, "1.70" or "17/10", a Fraction and an int are what they say. read_balls() has both for a
    file: flowcert.pores(*flowcert.read_balls(path, "bondi")). Balls are not merged.
    depth: tells chambers whose peak is this much wider than their gate, or more; exact, as a radius is.
    threads: how many compute; all cores without it. Ctrl-C comes through afterwards.

    The balls are a finite set, and beyond them is the outside. Elsewhere twice a peak is called largest cavity diameter
    (LCD) or pore diameter, twice an exit pore limiting diameter (PLD), and twice the value of a window its diameter. Of
    a crystal, which has no end, these are other numbers.

    >>> cage = pores([[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]], radii="1.70")
    >>> [chamber] = cage.chambers
    >>> chamber.diameter, chamber.limiting_diameter, [cage.windows[k].rooms for k in chamber.windows]
    (3.5282032302755093, 3.1319726474218084, [(0, -1), (0, -1), (0, -1), (0, -1)])
    >>> chamber.status("1.5"), chamber.status("1.7"), chamber.status("1.8")
    ('open', 'closed', 'too small')
    """
    return Pores(_balls.ball_rows(points, radii), _balls.length(depth, "depth"), thread_count(threads))


def cavities(points: Union[ArrayLike, Sequence[Sequence[Any]]], radii: Any, probe: Any) -> List[NDArray[np.int64]]:
    """The rooms between atoms with radii that have a place for a probe, and no way out for it. A list of int64 arrays:
    for each the rows of the balls that the probe can touch there, ascending.

    points, radii: as pores() takes them. Repeated rows are balls of their own. probe: a radius, 0 or more, beyond the
    balls' surfaces; exact, as these are. To touch is to fit. Pores.cavities_at counts the same for any probe, where
    pores() has taken its time. Ctrl-C comes through afterwards.

    >>> cage = [[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]]
    >>> [[rows.tolist() for rows in cavities(cage, 1, probe)] for probe in ("2.2", "2.4", "2.6")]
    [[], [[0, 1, 2, 3]], []]
    """
    radius = _exact.hexadecimal(_balls.length(probe, "probe"))
    return _core.ball_cavities(_balls.ball_rows(points, radii), radius)
