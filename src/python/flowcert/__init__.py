"""The flow complex of points in three dimensions, exactly, on every input.

The critical points of the distance function of a point set, and the flow between them, as Cazals, Parameswaran and
Pion describe it (Robust construction of the three-dimensional flow complex, 2008). Every decision is exact, however
degenerate the points are.

    >>> import flowcert
    >>> fc = flowcert.FlowComplex([[0, 0, 0], [6, 0, 0], [2, 4, 0]])
    >>> fc.counts
    (3, 3, 1, 0)
    >>> fc.persistence()
    [(0, (0.0, 5.0)), (0, (0.0, 8.0)), (0, (0.0, inf)), (1, (9.0, 10.0))]

What there is:

    FlowComplex(points)     critical points, persistence, surfaces, lines, orbits, volumes, connections; show() is its
                            picture, in notebooks and for browsers
    check(points, claim)    whether critical points that you have computed are right, and which are not
    represents(loops, pair) whether loops stand for a tunnel
    pores(points, radii)    the rooms between atoms with radii, with their gates and windows
    cavities(points, radii, probe)  the rooms that a probe cannot leave, with the atoms around them
    read_points(path)       the points of a PLY, OBJ, OFF or text file, or the atoms of a molecule
    read_balls(path, radii) these with their radii, exactly
    from_ase(atoms)         the atoms of an object of ASE, with radii; also from_mdanalysis and from_gemmi
    generate(family, seed)  degenerate inputs to test programs with
    families()              the names of the families, with a line on each
    flowcert.sklearn        persistence diagrams in pipelines of scikit-learn, a module to import by itself

Lengths have the unit of the points, squared distances its square, and volumes its cube. An input that cannot be used
is a ValueError of one line. What takes long runs without Python's lock, on all cores, and Ctrl-C stops it.

The package is free software under the GNU General Public License, version 3 or later, because CGAL's triangulations
are.
"""

from ._check import check
from ._core import made_by as __made_by__
from ._core import version as __version__
from ._cycles import Joined, Loop, Void, represents
from ._flow_complex import FlowComplex
from ._generate import families, generate
from ._judge import CheckReport, Finding
from ._limits import Direction, LambdaList
from ._manifolds import Lines, Mesh, Surfaces
from ._molecules import from_ase, from_gemmi, from_mdanalysis
from ._orbit import Limit, Orbit, Segment
from ._page import Page
from ._pockets import Places, Pocket, Pockets
from ._pores import Chamber, Pores, Window, cavities, pores
from ._quadratic_number import QuadraticNumber
from ._read_points import read_balls, read_points
from ._unstable import SurfaceCorner, UnstableInterval, UnstableSegment, UnstableSheet, UnstableSurface

__all__ = [
    "Chamber",
    "CheckReport",
    "Direction",
    "Finding",
    "FlowComplex",
    "Joined",
    "LambdaList",
    "Limit",
    "Lines",
    "Loop",
    "Mesh",
    "Orbit",
    "Page",
    "Places",
    "Pocket",
    "Pockets",
    "Pores",
    "QuadraticNumber",
    "Segment",
    "SurfaceCorner",
    "Surfaces",
    "UnstableInterval",
    "UnstableSegment",
    "UnstableSheet",
    "UnstableSurface",
    "Void",
    "Window",
    "__made_by__",
    "__version__",
    "cavities",
    "check",
    "families",
    "from_ase",
    "from_gemmi",
    "from_mdanalysis",
    "generate",
    "pores",
    "read_balls",
    "read_points",
    "represents",
]
