"""Persistence diagrams and barcodes, by matplotlib, which is imported when it is asked for."""

import math
from typing import TYPE_CHECKING, Any, Iterator, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _exact

if TYPE_CHECKING:
    from ._flow_complex import FlowComplex

_NAMES = ("components", "tunnels", "voids")


class _Intervals:
    """All pairs, and the place on an axis for those that last."""

    def __init__(self, fc: "FlowComplex", zero: bool, dimension: Optional[int], squared: bool) -> None:
        pairs = fc.persistence_pairs(zero=zero, dimension=dimension, squared=squared)
        numbers = np.concatenate([pairs["birth"], pairs["death"]])
        self.infinity = 1.1 * (float(numbers[np.isfinite(numbers)].max(initial=0.0)) or 1.0)
        self.pairs = pairs
        self.lasts = bool((pairs["death"] == math.inf).any())
        self.what = "squared distance" if squared else "distance"
        self.width = min(4.0, max(1.0, 150 / max(len(pairs), 1)))  # of a bar, in points

    def by_dimension(self) -> Iterator[Tuple[int, NDArray[Any], NDArray[Any]]]:
        """(dimension, births, deaths), of those dimensions that have pairs."""
        for dimension in range(3):
            pairs = self.pairs[self.pairs["dimension"] == dimension]
            if len(pairs):
                yield dimension, *(np.minimum(pairs[name], self.infinity) for name in ("birth", "death"))


_intervals = _exact.in_ieee_doubles(_Intervals)


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.subplots()[1]


def plot_diagram(
    self: "FlowComplex",
    ax: Any = None,
    *,
    zero: bool = False,
    dimension: Optional[int] = None,
    squared: bool = True,
) -> Any:
    """Draws the persistence diagram, a point for each pair: birth to the right, death upwards. Returns the axes of
    matplotlib, which has to be there.

    ax: the axes to draw in; those of a new figure without it.
    zero, dimension, squared: as persistence() takes them; squared=False is in the unit of the points. What lasts is on
    a line of its own, above all others.

    >>> FlowComplex([[0, 0, 0], [4, 0, 0]]).plot_diagram(squared=False).get_xlabel()  # doctest: +SKIP
    'birth (distance)'
    """
    ax = _axes(ax)
    intervals = _intervals(self, zero, dimension, squared)
    ax.axline((0, 0), slope=1, color="0.7", linewidth=0.8, zorder=0)
    if intervals.lasts:
        ax.axhline(intervals.infinity, color="0.7", linewidth=0.8, linestyle="--", zorder=0)
        ax.annotate("∞", (0, intervals.infinity), (-3, 0), ("axes fraction", "data"), "offset points", ha="right",
                    va="center")  # fmt: skip
    for k, births, deaths in intervals.by_dimension():
        ax.plot(births, deaths, "o", markersize=4, alpha=0.7, color=f"C{k}", label=f"{k}: {_NAMES[k]}")
    if len(intervals.pairs):
        ax.legend(loc="lower right")
    ax.set_xlabel(f"birth ({intervals.what})")
    ax.set_ylabel(f"death ({intervals.what})")
    return ax


def plot_barcode(
    self: "FlowComplex",
    ax: Any = None,
    *,
    zero: bool = False,
    dimension: Optional[int] = None,
    squared: bool = True,
) -> Any:
    """Draws the barcode, a bar from birth to death for each pair, in the order of persistence(), upwards. Returns the
    axes of matplotlib, which has to be there.

    ax, zero, dimension, squared: as plot_diagram() takes them. What lasts goes on to the right edge. Each point has a
    bar of dimension 0, so that those of a scan are best seen by dimension.

    >>> len(FlowComplex([[0, 0, 0], [4, 0, 0]]).plot_barcode().collections)  # doctest: +SKIP
    1
    """
    ax = _axes(ax)
    intervals = _intervals(self, zero, dimension, squared)
    first = 0
    for k, births, deaths in intervals.by_dimension():
        rows = np.arange(first, first + len(births))
        ax.hlines(rows, births, deaths, color=f"C{k}", linewidth=intervals.width, label=f"{k}: {_NAMES[k]}")
        first += len(births)
    if len(intervals.pairs):
        ax.legend(loc="lower right")
    ax.set_xlim(left=0, right=intervals.infinity if intervals.lasts else None)
    ax.set_yticks([])
    ax.set_xlabel(intervals.what)
    return ax
