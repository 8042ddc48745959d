"""Atoms that another library has read, as pores() and FlowComplex take them. No library is imported here."""

import os
from fractions import Fraction
from typing import Any, List, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _core, _exact
from ._read_points import atom_array

_Balls = Tuple[NDArray[np.float64], NDArray[np.object_], NDArray[Any]]


def from_ase(atoms: Any, radii: Any = "bondi", *, finite: bool = False) -> _Balls:
    """The atoms of an ase.Atoms: (points, radii, names), as read_balls(..., return_atoms=True) has them of a file, but
    points are doubles, (n, 3).

    radii: a number for all, or as read_balls() takes it where it goes by element: "bondi", "alvarez" or "table:FILE",
    each also with overrides behind it, as "bondi,Fe=2.04".
    finite: take the atoms of a periodic cell, which are refused else, without their copies.

    >>> points, radii, names = from_ase(ase.build.molecule("C60"))  # doctest: +SKIP
    >>> pores(points, radii).show(atoms=names)  # doctest: +SKIP
    """
    if np.any(atoms.pbc) and not finite:
        raise ValueError("the atoms are those of a periodic cell; with finite=True its copies are left out")
    return _balls(atoms.positions, [("", "", "", "", element) for element in atoms.get_chemical_symbols()], radii)


def from_mdanalysis(atoms: Any, radii: Any = "bondi") -> _Balls:
    """The atoms of an MDAnalysis Universe or AtomGroup, in the frame that it is at: (points, radii, names), as
    from_ase() has them. Its coordinates are floats of 32 bits, and taken as they are.

    radii: as from_ase() takes it. The elements have to be known, as they are of a PDB file; otherwise
    universe.add_TopologyAttr("elements", ...) says them.

    >>> points, radii, names = from_mdanalysis(universe.select_atoms("protein"))  # doctest: +SKIP
    """
    group = atoms.atoms

    def texts(*attributes: str) -> List[str]:
        for attribute in attributes:  # MDAnalysis has those that the file has
            values = getattr(group, attribute, None)
            if values is not None:
                return [str(value).strip() for value in values]
        return [""] * len(group)

    numbers = ["".join(parts) for parts in zip(texts("resids"), texts("icodes"))]
    names = zip(texts("chainIDs", "segids"), texts("resnames"), numbers, texts("names"), texts("elements"))
    return _balls(group.positions, list(names), radii)


def from_gemmi(structure: Any, radii: Any = "bondi") -> _Balls:
    """The atoms of a gemmi.Structure, of its first model; or of a gemmi.Model: (points, radii, names), as from_ase()
    has them. Of an atom with alternate locations the first is taken. Copies by symmetry are left out.

    radii: as from_ase() takes it.

    >>> points, radii, names = from_gemmi(gemmi.read_structure("protein.cif"))  # doctest: +SKIP
    """
    model = structure[0] if hasattr(structure, "spacegroup_hm") else structure
    points, names, read, named = [], [], set(), {}
    for chain in model:
        for residue in chain:
            for atom in residue:
                place = chain.name, str(residue.seqid)
                if atom.altloc != "\0":  # as read_points() does it
                    if named.setdefault(place, residue.name) != residue.name or (place, atom.name) in read:
                        continue
                    read.add((place, atom.name))
                points.append(atom.pos.tolist())
                names.append((chain.name, residue.name, str(residue.seqid), atom.name, atom.element.name))
    return _balls(points, names, radii)


def _balls(points: Any, names: List[Tuple[str, str, str, str, str]], radii: Any) -> _Balls:
    rows = np.array(points, dtype=np.float64).reshape(-1, 3)
    return rows, _radii([name[4] for name in names], radii), atom_array(names)


def _radii(elements: Sequence[str], radii: Any) -> NDArray[np.object_]:
    words = os.fsencode(radii) if isinstance(radii, str) else _exact.words(radii, "radii")
    different = sorted(set(elements))
    found = dict(zip(different, _core.element_radii(different, words)))
    for row, element in enumerate(elements):
        if found[element] is None:
            what = f"the element {element!r}, which has no radius there" if element else "no element"
            raise ValueError(f"radii: atom {row} has {what}")
    values = {element: Fraction(*ratio) for element, ratio in found.items() if ratio is not None}
    return np.array([values[element] for element in elements], dtype=object)
