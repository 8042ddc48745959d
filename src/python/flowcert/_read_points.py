"""Point files, as every command of flowcert reads them."""

import os
from typing import Union

import numpy as np
from numpy.typing import NDArray

from . import _core


def file_name(path: Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]) -> bytes:
    """The bytes that the system knows it by: those that are no UTF-8 are surrogates in Python."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError(f"{os.fsdecode(name)!r} is no name of a file, because it has a null character")
    return name


def read_points(path: Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]) -> NDArray[np.float64]:
    """The points of a file, an (n, 3) array of doubles: XYZ/text, OFF, PLY, OBJ, or a molecule, PDB or mmCIF, each also as
    .gz; "-" for standard input.

    The ending of the name says the format. Coordinates are the doubles that the file means. A file that is not as its
    format says is a ValueError with its name and line.
    """
    return _core.read_points(file_name(path))
