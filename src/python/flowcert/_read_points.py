"""Point files, as every command of flowcert reads them, and atoms with their radii."""

import operator
import os
import warnings
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core, _exact


def file_name(path: Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]) -> bytes:
    """The bytes that the system knows it by: those that are no UTF-8 are surrogates in Python."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError(f"{os.fsdecode(name)!r} is no name of a file, because it has a null character")
    return name


def _words(words: Union[None, str, Sequence[Union[int, str]]]) -> "list[str]":
    if words is None:
        return []
    return [words] if isinstance(words, str) else [str(word) for word in words]


def atom_array(names: "list[Tuple[str, str, str, str, str]]") -> NDArray[Any]:
    widths = [max((len(name[k]) for name in names), default=1) or 1 for k in range(5)]
    fields = ("chain", "residue", "number", "atom", "element")
    return np.array(names, dtype=[(field, f"U{width}") for field, width in zip(fields, widths)])


def read_points(
    path: Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"], *, format: Optional[str] = None,
    columns: Union[None, str, Sequence[Union[int, str]]] = None, z: Optional[float] = None,
    atoms: Union[None, str, Sequence[str]] = None, chains: Union[None, str, Sequence[str]] = None,
    models: Union[None, str, int, Sequence[int]] = None, frame: Optional[int] = None, skip_invalid: bool = False,
    return_left_out: bool = False, return_atoms: bool = False, unlimited: bool = False,
) -> Union[NDArray[np.float64], Tuple[NDArray[Any], ...]]:  # fmt: skip
    """The points of a file, an (n, 3) array of doubles; "-" for standard input.

    The content says the format: a table of numbers or CSV, PTS, chemical XYZ, OFF, PLY, OBJ, PCD, NPY, or a molecule,
    PDB or CIF, each also compressed by gzip. The arguments are the options of the commands, with the same words:
    format="table", columns="2,3,4" or "x,y,z", z=0 for two columns, atoms=["protein", "no hydrogens"], chains="A",
    models="all", frame=2, of which the first is 1, skip_invalid=True to leave out rows with NaN, and unlimited=True for
    compressed files that grow to more than a hundred times their size. With return_left_out=True the numbers of the
    rows that are left out, from 0, are returned, too. With return_atoms=True so is a structured array of names, one for
    each point, with the strings chain, residue, number (of the residue, with its insertion code), atom and element; it
    has no rows if the file is no molecule. Pocket.lining are its rows.

    Coordinates are the doubles that the file means. A file that can be read in two ways, or in none, is a ValueError
    with its name and line. What a command tells as a note is a warning.
    """
    rows, _, more = _read(
        path, None, False, format, columns, z, atoms, chains, models, frame, skip_invalid, return_left_out,
        return_atoms, unlimited)  # fmt: skip
    return (rows, *more) if more else rows


def read_balls(
    path: Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"], radii: Any, *, finite: bool = False,
    **options: Any,
) -> Tuple[NDArray[Any], ...]:  # fmt: skip
    """The atoms of a file with their radii, as pores() takes them: (points, radii), arrays of Fractions, (n, 3) and
    (n,), in the unit of the file.

    Decimals are taken as they are written, and floats of binary files as the doubles that they are.
    radii: a number for all, or as --radii of the commands takes it: "bondi" or "alvarez", by element; "pqr", those of a
    PQR file; "column:4" of a table; "table:FILE", lines with an element and its radius; each also with overrides behind
    it, as "bondi,Fe=2.04".
    finite: take the atoms of a crystal's cell, which are refused else, without their copies.
    Other arguments are those of read_points; what is returned for return_left_out and return_atoms comes behind.
    """
    words = os.fsencode(radii) if isinstance(radii, str) else _exact.words(radii, "radii")
    _, balls, more = _read(path, words, bool(finite), **{**(read_points.__kwdefaults__ or {}), **options})
    centres = np.array([_exact.fractions(centre) for centre, _ in balls], dtype=object).reshape(-1, 3)
    return (centres, np.array([_exact.fraction(radius) for _, radius in balls], dtype=object), *more)


def _read(path, radii, finite, format, columns, z, atoms, chains, models, frame, skip_invalid, return_left_out,
          return_atoms, unlimited):  # fmt: skip
    """(rows, balls, more)"""
    number = 0 if frame is None else operator.index(frame)
    if frame is not None and not 0 < number < 2**63:
        raise ValueError("frame must be 1 or more")
    name = file_name(path)
    columns, models = (",".join(_words(some)) for some in (columns, [models] if isinstance(models, int) else models))
    try:
        rows, notes, left_out, names, balls = _core.read_points(
            name, "" if format is None else format, columns, z, _words(atoms), _words(chains), models, number,
            skip_invalid, unlimited, finite, return_atoms, radii)  # fmt: skip
    except TypeError:
        raise ValueError("format must be a str, and z a number") from None
    for line, text in notes:
        warnings.warn(f"{os.fsdecode(path)}{f':{line}' if line else ''}: {text}", stacklevel=3)
    more = [np.array(left_out, dtype=np.int64)] if return_left_out else []
    if return_atoms:
        more.append(atom_array(names))
    return rows, balls, more
