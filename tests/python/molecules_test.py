"""from_ase, from_mdanalysis and from_gemmi read the same atoms as read_balls does."""

import pathlib
from fractions import Fraction

import flowcert
import numpy as np
import pytest

INPUTS = pathlib.Path(__file__).parents[1] / "inputs"
# Two locations of an atom, and two residues at one place. The second chain has an insertion code.
LINES = """\
ATOM      1  N   GLY A   1       0.000   0.125   3.100  1.00  0.00           N
ATOM      2  CA AGLY A   1       1.400   0.000   0.000  0.40  0.00           C
ATOM      3  CA BGLY A   1       1.500   0.000   0.000  0.60  0.00           C
ATOM      4  OG ASER A   2       4.000   0.000   0.000  0.50  0.00           O
ATOM      5  SG BCYS A   2       4.000   0.300   0.000  0.50  0.00           S
ATOM      6 FE   HEM B  10A      9.000   9.000   9.100  1.00  0.00          FE
END
"""


@pytest.fixture
def pdb(tmp_path):
    path = tmp_path / "small.pdb"
    path.write_text(LINES)
    return path


def radii_of(radii):
    assert all(type(radius) is Fraction for radius in radii)
    return radii.tolist()


def test_ase_has_the_cage():
    ase_io = pytest.importorskip("ase.io", reason="no ASE: python3-ase has it")
    path = INPUTS / "cage.xyz"
    points, radii, names = flowcert.from_ase(ase_io.read(path))
    with pytest.warns(UserWarning, match="hydrogens"):
        _, said, said_names = flowcert.read_balls(path, "bondi", return_atoms=True)
        assert (points == flowcert.read_points(path)).all() and points.dtype == np.float64
    assert radii_of(radii) == said.tolist() and names["element"].tolist() == said_names["element"].tolist()
    assert f"{flowcert.pores(points, radii, depth=0.5).chambers[0].diameter:.6f}" == "5.397020"


def test_the_example_of_ase():
    build = pytest.importorskip("ase.build", reason="no ASE: python3-ase has it")
    points, radii, names = flowcert.from_ase(build.molecule("C60"))
    assert len(points) == 60 and set(names["element"]) == {"C"}
    assert len(flowcert.pores(points, radii).show(atoms=names).html) > 100_000


def test_ase_with_other_radii_and_a_cell():
    ase = pytest.importorskip("ase", reason="no ASE: python3-ase has it")
    atoms = ase.Atoms("CFeO", [[0, 0, 0], [0, 0, 2], [0, 2, 0.5]])
    assert radii_of(flowcert.from_ase(atoms, "1/3")[1]) == [Fraction(1, 3)] * 3
    assert radii_of(flowcert.from_ase(atoms, 0.5)[1]) == [Fraction(1, 2)] * 3
    assert radii_of(flowcert.from_ase(atoms, "bondi,Fe=2.04")[1]) == [Fraction(x, 100) for x in (170, 204, 152)]
    with pytest.raises(ValueError, match="radii: atom 1 has the element 'Fe', which has no radius there"):
        flowcert.from_ase(atoms)
    with pytest.raises(ValueError, match="radii: atom 0 has the element 'X', which has no radius there"):
        flowcert.from_ase(ase.Atoms("X", [[0, 0, 0]]))
    with pytest.raises(ValueError, match="--radii:1: "):
        flowcert.from_ase(atoms, "bandi")
    atoms.set_cell([9, 9, 9])
    atoms.set_pbc([True, False, False])
    with pytest.raises(ValueError, match="those of a periodic cell; with finite=True"):
        flowcert.from_ase(atoms)
    assert len(flowcert.from_ase(atoms, 1, finite=True)[0]) == 3
    points, radii, names = flowcert.from_ase(ase.Atoms())
    assert points.shape == (0, 3) and radii.shape == names.shape == (0,)


@pytest.mark.filterwarnings("ignore")
def test_gemmi_has_the_atoms_of_a_file(pdb):
    gemmi = pytest.importorskip("gemmi", reason="no gemmi: python3-gemmi has it")
    balls, said, said_names = flowcert.read_balls(pdb, "bondi,Fe=2", return_atoms=True)
    structure = gemmi.read_structure(str(pdb))
    for of in (structure, structure[0]):
        points, radii, names = flowcert.from_gemmi(of, "bondi,Fe=2")
        assert points.tolist() == balls.astype(float).tolist() and radii_of(radii) == said.tolist()
        # gemmi has symbols as the periodic table has them.
        said_names["element"] = [element.capitalize() for element in said_names["element"]]
        assert names.tolist() == said_names.tolist()
    assert names["number"].tolist() == ["1", "1", "2", "10A"] and names["element"].tolist() == ["N", "C", "O", "Fe"]


@pytest.mark.filterwarnings("ignore")
def test_mdanalysis_has_the_atoms_of_a_file(pdb):
    mda = pytest.importorskip("MDAnalysis", reason="no MDAnalysis: python3-mdanalysis has it")
    universe = mda.Universe(str(pdb))
    points, radii, names = flowcert.from_mdanalysis(universe, "bondi,Fe=2")
    assert points.dtype == np.float64 and (points == universe.atoms.positions.astype(np.float64)).all()
    assert names["element"].tolist() == ["N", "C", "C", "O", "S", "Fe"] and names["number"].tolist()[-1] == "10A"
    assert names["chain"].tolist() == list("AAAAAB") and names["atom"].tolist()[1] == "CA"
    assert radii_of(radii) == [Fraction(x, 100) for x in (155, 170, 170, 152, 180, 200)]
    points, _, names = flowcert.from_mdanalysis(universe.select_atoms("resname HEM"), 1)
    assert points.shape == (1, 3) and names["residue"].tolist() == ["HEM"]
    with pytest.raises(ValueError, match="radii: atom 0 has no element"):
        flowcert.from_mdanalysis(mda.Universe.empty(2, trajectory=True))
