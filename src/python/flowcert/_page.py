"""The viewer's page, for notebooks and files."""

import os
import tempfile
from html import escape
from typing import TYPE_CHECKING, Any, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _balls, _exact

if TYPE_CHECKING:
    from ._flow_complex import FlowComplex
    from ._pores import Pores

_FIELDS = ("chain", "residue", "number", "atom", "element")


class Page:
    """A page that shows a complex, or balls, in a browser without a network: what show() returns.

    In a notebook it is shown in a frame, where it is the last value of a cell. Elsewhere save it, and open the file in
    a browser; a script that is done needs no page any more, so none is opened by itself.

    html    str, the whole page, which is free of the GPL
    height  int, the frame's height in a notebook, in pixels
    """

    def __init__(self, html: str, height: int) -> None:
        self.html = html
        self.height = height

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the page to this file, whole or not at all.

        >>> FlowComplex([[0, 0, 0], [2, 0, 0]]).show().save("page.html")  # doctest: +SKIP
        """
        folder, name = os.path.split(os.path.abspath(path))
        handle, partial = tempfile.mkstemp(prefix=f".{name}.", dir=folder)
        try:
            with open(handle, "w", encoding="utf-8") as file:
                file.write(self.html)
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(partial, 0o666 & ~mask)
            os.replace(partial, path)
        except BaseException:
            os.unlink(partial)
            raise

    def _repr_html_(self) -> str:
        # A frame of its own origin: nothing in the page can reach the notebook.
        return (
            f'<iframe srcdoc="{escape(self.html)}" sandbox="allow-scripts allow-downloads allow-popups" '
            f'style="width:100%;height:{self.height}px;border:0" title="flowcert"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<flowcert.Page of {len(self.html) / 1e6:.1f} MB: save(path) writes it>"


def _rows(atoms: Any) -> List[Tuple[str, ...]]:
    if atoms is None:
        return []
    array = np.asarray(atoms)
    if array.ndim != 1 or array.dtype.names is None or not set(_FIELDS) <= set(array.dtype.names):
        raise ValueError("atoms must be what read_points(..., return_atoms=True) returns last")
    return list(zip(*(array[field].tolist() for field in _FIELDS)))


def _page(content: bytes, height: int) -> Page:
    return Page(content.decode("utf-8", errors="replace"), int(height))


def show(
    self: "FlowComplex",
    *,
    name: str = "points",
    atoms: Optional[NDArray[Any]] = None,
    cells: bool = False,
    pockets: Any = None,
    most: int = 150_000,
    height: int = 600,
) -> Page:
    """The page of `flowcert view`, which shows the complex in 3D with its persistence diagram: a Page. A notebook shows
    it in a frame. Elsewhere, fc.show().save("page.html") writes it to a file for a browser.

    name: of the points, as the page tells it.
    atoms: the names of a molecule's atoms, as read_points(..., return_atoms=True) has them. The page names atoms and
    draws them in the colours of their elements.
    cells: also the cells of dimension 3, and what flows from critical points of index 1.
    pockets: also pockets, merged at this persistence, as pockets() takes it.
    most: of more critical points of an index from 1 on, those of so many pairs, the longest. The page of a scan of
    35,000 points has 15 MB.
    height: of the frame, in pixels.

    >>> FlowComplex([[0, 0, 0], [2, 0, 0]]).show()  # doctest: +ELLIPSIS
    <flowcert.Page of ... MB: save(path) writes it>
    """
    if most < 1:
        raise ValueError("most: less than 1")
    persistence = None if pockets is None else _exact.words(pockets, "pockets")
    return _page(self._core.page(str(name), _rows(atoms), most, bool(cells), persistence), height)


def show_pores(
    self: "Pores",
    *,
    name: str = "balls",
    atoms: Optional[NDArray[Any]] = None,
    probe: Any = None,
    height: int = 600,
) -> Page:
    """The page of `flowcert view --radii`, which shows the balls, and the chambers between them with their windows: a
    Page. A notebook shows it in a frame. Elsewhere, show().save("page.html") writes it to a file for a browser.

    name, atoms, height: as FlowComplex.show() takes them. probe: a radius; each chamber is said to be open or closed
    for such a probe.

    >>> pores([[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]], radii="1.70").show(probe="1.5")  # doctest: +ELLIPSIS
    <flowcert.Page of ... MB: save(path) writes it>
    """
    centres = np.array(
        [[_exact.nearest_double(value) for value in row[:3]] for row in self._made_of[0]], dtype=np.float64
    ).reshape(-1, 3)
    radius = None if probe is None else _exact.hexadecimal(_balls.length(probe, "probe"))
    return _page(self._core.page(str(name), centres, _rows(atoms), radius), height)


show_pores.__name__ = "show"
