"""to_pyvista, to_trimesh and to_meshio have what the files of `flowcert compute --export` have, to the bit."""

import base64
import binascii
import re
import xml.etree.ElementTree as tree

import flowcert
import numpy as np
import pytest
from conftest import CUBE, flowcert_says
from flowcert._exports import _PARTS, _Cells, _data_set

TYPES = {"Int8": np.int8, "UInt8": np.uint8, "Int64": np.int64, "Float64": np.float64}
CELLS = {"PolyData": ("Verts", "Lines", "Polys"), "UnstructuredGrid": ("Cells",)}
RANDOM = np.random.default_rng(1).random((14, 3))
INPUTS = {
    "random": RANDOM,
    "cube": CUBE,
    "right triangle": np.array([[0.0, 0, 0], [3, 0, 0], [0, 4, 0]]),
    "two": np.array([[0.0, 0, 0], [2, 0, 0]]),
    "none": np.empty((0, 3)),
}


class File:
    """A file of VTK with appended data, as the program writes it."""

    def __init__(self, path):
        head, raw = path.read_bytes().split(b'<AppendedData encoding="raw">\n_', 1)
        root = tree.fromstring(head + b"</VTKFile>")
        self.kind = root.get("type")
        self.raw = raw
        self.piece = root.find(f"{self.kind}/Piece")

    def arrays(self, section):
        found = {}
        for array in self.piece.find(section) if self.piece.find(section) is not None else []:
            offset, components = int(array.get("offset")), int(array.get("NumberOfComponents", 1))
            size = int.from_bytes(self.raw[offset : offset + 8], "little")
            values = np.frombuffer(self.raw[offset + 8 : offset + 8 + size], TYPES[array.get("type")])
            found[array.get("Name")] = values.reshape(-1, components) if components > 1 else values
        return found


@pytest.fixture(scope="module", params=INPUTS)
def exported(request, tmp_path_factory):
    """(complex, {part: file}), of all parts that the program writes."""
    folder = tmp_path_factory.mktemp("exports")
    np.save(folder / "points.npy", INPUTS[request.param])
    only = "critical,surfaces,lines,fans,cells,infinity,sheets"
    flowcert_says("compute", folder / "points.npy", "--manifolds", "all", "--export", folder, "--only", only)
    files = {path.stem: path for path in folder.iterdir() if path.suffix in (".vtp", ".vtu")}
    return flowcert.FlowComplex(INPUTS[request.param]), files


def same(first, second):
    return first.dtype == second.dtype and first.shape == second.shape and first.tobytes() == second.tobytes()


def test_the_parts_are_the_files(exported):
    fc, files = exported
    assert set(files) == set(_PARTS)
    for part, path in files.items():
        data, file = _data_set(fc, part, None, 3), File(path)
        assert same(data.points, file.arrays("Points")["Points"].reshape(-1, 3)), part
        for cells, section in zip(data.cells, CELLS[file.kind]):
            arrays = file.arrays(section)
            assert same(cells.connectivity, arrays["connectivity"]) and same(cells.offsets, arrays["offsets"]), part
        if file.kind == "UnstructuredGrid":
            assert same(data.shapes, file.arrays("Cells")["types"]), part
        for arrays, section in ((data.point_data, "PointData"), (data.cell_data, "CellData")):
            said = file.arrays(section)
            assert set(arrays) == set(said) and all(same(arrays[name], said[name]) for name in said), part


def test_without_a_box_nothing_is_cut():
    fc = flowcert.FlowComplex(RANDOM)
    assert "IsClipped" in _data_set(fc, "unstable_lines", None, "3/2").point_data
    assert "IsClipped" not in _data_set(fc, "unstable_lines", None, None).point_data


def test_a_selected_surface_is_that_of_surface():
    fc = flowcert.FlowComplex(RANDOM)
    vertices, faces = fc.surface("largest-gaps=2")
    data = _data_set(fc, "stable_surfaces", ["largest-gaps=2"], 3)
    assert same(data.points, vertices) and (data.cells[2].connectivity == faces.ravel()).all()
    assert len(set(data.cell_data["SourceId"])) == 2


@pytest.mark.parametrize(
    "arguments, words",
    [
        ({"part": "surface"}, "part: there is no 'surface'; there are critical_points, "),
        ({"part": "unstable_lines", "select": "largest-gaps=2"}, "select: for stable_surfaces alone"),
        ({"select": "largest-gaps"}, "select: "),
        ({"select": ["largest-gaps=2", "x"]}, r"select\[1\]: "),
        ({"clip": 0.5}, "clip must be a number from 1, or None"),
        ({"clip": "far"}, "clip: far is not a finite number"),
    ],
)
def test_what_cannot_be_asked(arguments, words):
    with pytest.raises(ValueError, match=words) as caught:
        _data_set(flowcert.FlowComplex(CUBE), **{"part": "stable_surfaces", "select": None, "clip": 3, **arguments})
    assert "\n" not in str(caught.value) and not re.search("--", str(caught.value))


def test_cells_of_several_sizes():
    cells = _Cells(np.array([7, 0, 1, 2, 3, 4, 5, 6]), np.array([1, 4, 8]))
    assert cells.padded().tolist() == [1, 7, 3, 0, 1, 2, 4, 3, 4, 5, 6]
    assert [rows.tolist() for rows in cells.of_size(3)] == [[[0, 1, 2]], [1]]
    assert [rows.tolist() for rows in cells.triangles()] == [[[0, 1, 2], [3, 4, 5], [3, 5, 6]], [1, 2, 2]]
    assert [rows.tolist() for rows in cells.steps()] == [[[0, 1], [1, 2], [3, 4], [4, 5], [5, 6]], [1, 1, 2, 2, 2]]
    none = _Cells(np.empty(0, np.int64), np.empty(0, np.int64))
    assert [len(some) for some in (*none.steps(), *none.triangles(), *none.of_size(3), none.padded())] == [0] * 7


# ---- The libraries themselves


def test_pyvista_has_what_it_reads_of_the_files(exported):
    pyvista = pytest.importorskip("pyvista")
    fc, files = exported
    for part, path in files.items():
        made, read = fc.to_pyvista(part), pyvista.read(path)
        assert type(made) is type(read) is (pyvista.UnstructuredGrid if path.suffix == ".vtu" else pyvista.PolyData)
        assert made.n_cells == read.n_cells and same(np.array(made.points), np.array(read.points).astype(float)), part
        assert [made.get_cell(k).point_ids for k in range(made.n_cells)] == [
            read.get_cell(k).point_ids for k in range(read.n_cells)
        ]
        for ours, theirs in ((made.point_data, read.point_data), (made.cell_data, read.cell_data)):
            assert set(ours.keys()) == set(theirs.keys()), part
            assert all(same(np.array(ours[name]), np.array(theirs[name])) for name in theirs.keys()), part


def test_pyvista_measures_what_is_known():
    pytest.importorskip("pyvista")
    fc = flowcert.FlowComplex(CUBE)
    assert fc.to_pyvista().area == pytest.approx(6) and fc.to_pyvista("stable_cells").volume == pytest.approx(1)
    assert fc.to_pyvista("infinity_cells").volume == pytest.approx(26)


def ends_at_padding():
    """Whether Python's base64 ends there. Versions since 2026 read on, and then meshio reads no appended arrays."""
    try:
        return base64.b64decode("AA==AAAA") == b"\0"
    except binascii.Error:
        return False


def test_meshio_reads_the_same_cells(exported):
    meshio = pytest.importorskip("meshio")
    if not ends_at_padding():
        pytest.skip("meshio reads no appended arrays with this Python")
    fc, files = exported
    made = fc.to_meshio("stable_cells")
    if len(made.points) == 0:
        assert made.cells == []
        return
    read = meshio.read(files["stable_cells"])
    assert same(made.points, read.points)
    cells = lambda mesh: sorted(tuple(row) for block in mesh.cells for row in block.data.tolist())
    assert cells(made) == cells(read)
    volumes = lambda mesh: sorted(np.concatenate(mesh.cell_data["volume"]).ravel().tolist())
    assert volumes(made) == volumes(read)


def test_meshio_has_each_piece_with_the_arrays_of_its_line(tmp_path):
    meshio = pytest.importorskip("meshio")
    fc = flowcert.FlowComplex(RANDOM)
    mesh, lines = fc.to_meshio("unstable_lines"), _data_set(fc, "unstable_lines", None, 3)
    [block] = [block for block in mesh.cells if block.type == "line"]
    assert len(block.data) == (lines.cells[1].sizes - 1).sum()
    ends = {name: mesh.point_data["SquaredDistance"][block.data[:, k]] for k, name in enumerate(("start", "end"))}
    assert (ends["start"] < ends["end"]).all()  # the flow ascends
    first = np.concatenate([[True], block.data[1:, 0] != block.data[:-1, 1]])
    sources = mesh.cell_data["SourceId"][mesh.cells.index(block)]
    squared = fc.stationary_points["squared_distance"]
    assert (ends["start"][first] == squared[sources[first]]).all()
    for part in _PARTS:
        mesh = fc.to_meshio(part)
        mesh.write(tmp_path / f"{part}.vtu")
        again = meshio.read(tmp_path / f"{part}.vtu")
        assert sum(len(block.data) for block in again.cells) == sum(len(block.data) for block in mesh.cells)


def test_trimesh_has_surfaces_lines_and_points():
    trimesh = pytest.importorskip("trimesh")
    fc = flowcert.FlowComplex(CUBE)
    mesh = fc.to_trimesh()
    assert isinstance(mesh, trimesh.Trimesh) and mesh.area == pytest.approx(6) and abs(mesh.volume) == pytest.approx(1)
    assert same(np.array(mesh.vertices), fc.stable_surfaces().vertices)
    assert (mesh.face_attributes["SourceId"] == fc.stable_surfaces().saddles).all()
    assert (mesh.vertex_attributes["SquaredDistance"] == fc.stable_surfaces().squared_distances).all()
    sheets = fc.to_trimesh("unstable_surfaces", clip=None)
    assert set(sheets.face_attributes["kind"].tolist()) <= {3}
    lines = fc.to_trimesh("unstable_lines")
    assert len(lines.entities) == 12 and lines.metadata["SourceId"].tolist() == sorted([*range(20, 26)] * 2)
    points = fc.to_trimesh("critical_points")
    assert len(points.vertices) == 27 and points.metadata["CellDimension"].tolist()[-1] == 3
    with pytest.raises(ValueError, match="trimesh has no cells of dimension 3"):
        fc.to_trimesh("stable_cells")


@pytest.mark.parametrize("library", ["pyvista", "meshio", "trimesh"])
def test_examples(library, examples_hold, tmp_path):
    pytest.importorskip(library)
    assert examples_hold(getattr(flowcert.FlowComplex, f"to_{library}"))
    assert library != "meshio" or (tmp_path / "surfaces.vtu").stat().st_size > 0
