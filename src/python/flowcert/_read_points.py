"""Point files, as every command of flowcert reads them."""

import os
from typing import Union

import numpy as np
from numpy.typing import NDArray

from . import _core


def read_points(path: Union[str, "os.PathLike[str]"]) -> NDArray[np.float64]:
    """The points of a file, an (n, 3) array of doubles: XYZ/text, OFF, PLY or OBJ, each also as .gz; "-" for standard
    input.

    The ending of the name says the format. Coordinates are the doubles that the file means. A file that is not as its
    format says is a ValueError with its name and line.
    """
    return _core.read_points(os.fspath(path))
