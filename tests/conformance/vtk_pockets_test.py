"""What `flowcert pockets --export` writes, opened by VTK itself (src/cli/manual/pockets.md).

usage: vtk_pockets_test.py FLOWCERT

The cells of each pocket have its volume by VTK's own sums, and their arrays say which pocket it is, its volume and its
depth. Each surface is closed, with one orientation, and encloses the volume up to the floats that VTK's reader keeps.
"""
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction

from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from vtk_exports_test import DOUBLE, INPUTS, INT64, Faults, arrays_of, cells_of, points_of, random_points, read
from vtk_unstable_surfaces_test import dot, minus

# A name, the points, and a persistence.
CASES = [*((name, points, "0") for name, points in INPUTS.items() if name not in ("far", "subnormal")),
         ("lattice, merged", INPUTS["lattice"], "100"),
         ("random, merged", INPUTS["random"], "0.01"),
         ("crowd", random_points(7, 200), "0.003")]
ARRAYS = {"maximum": INT64, "sample": INT64, "pocket": INT64, "volume": DOUBLE, "depth": DOUBLE}


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def enclosed(positions, triangles):
    """The volume inside of closed triangles, which are counterclockwise, seen from outside."""
    apex = positions[0]
    return sum(dot(minus(positions[a], apex), cross(minus(positions[b], apex), minus(positions[c], apex)))
               for a, b, c in triangles) / 6


def is_near(a, b):
    return abs(a - b) <= 1e-9 * abs(b)


def check_cells(grid, pockets, records, faults):
    positions = points_of(grid, faults)
    cells = cells_of(grid, len(positions), faults)
    arrays = arrays_of(grid.GetCellData(), ARRAYS, len(cells), faults)
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    measured = sizes.GetOutput().GetCellData().GetArray("Volume")
    volumes, kinds = Counter(), Counter()
    for k in range(len(cells)):
        number = int(arrays["pocket"][k])
        pocket = pockets[number]
        volumes[number] += measured.GetTuple1(k)
        faults.expect(arrays["volume"][k] == pocket["volume"], f"volume of cell {k}")
        faults.expect(is_near(arrays["depth"][k], Fraction(pocket["depth"])), f"depth of cell {k}")
        limit = records[int(arrays["maximum"][k])]["contact"]
        faults.expect(limit in [part["contact"] for part in pocket["cell"]], f"cell {k} is not of its pocket")
        kinds[grid.GetCellType(k)] += 1
    for number, pocket in enumerate(pockets):
        faults.expect(is_near(volumes[number], pocket["volume"]), f"pocket {number}: volume {volumes[number]}")
    return kinds


def check_surface(poly_data, pocket, faults, name):
    # VTK's reader keeps floats.
    positions = [poly_data.GetPoint(k) for k in range(poly_data.GetNumberOfPoints())]
    triangles = cells_of(poly_data, len(positions), faults)
    faults.expect(len(triangles) > 3 and all(len(triangle) == 3 for triangle in triangles), f"{name}: no triangles")
    edges = Counter()
    for triangle in triangles:
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            edges[a, b] += 1
    # As many triangles go along an edge one way as the other.
    faults.expect(all(edges[b, a] == count for (a, b), count in edges.items()), f"{name} is not closed")
    box = 1.0
    for axis in zip(*positions):
        box *= max(axis) - min(axis)
    off = abs(enclosed(positions, triangles) - pocket["volume"])
    faults.expect(off <= 1e-5 * box, f"{name} encloses another volume")


def check_case(flowcert, folder, points, persistence, faults):
    source, target, output = (os.path.join(folder, name) for name in ("points.off", "files", "records.jsonl"))
    with open(source, "w", encoding="ascii") as file:
        file.writelines([f"OFF\n{len(points)} 0 0\n"] + ["%r %r %r\n" % point for point in points])
    for words in (["pockets", source, "--persistence", persistence, "--export", target],
                  ["compute", source, "-o", output]):
        run = subprocess.run([flowcert, *words], capture_output=True, text=True, timeout=200, check=False)
        faults.expect(run.returncode == 0, run.stderr)
    with open(output, encoding="utf-8") as file:
        records = [json.loads(line) for line in file][1:]
    with open(os.path.join(target, "pockets.json"), encoding="utf-8") as file:
        pockets = json.load(file)["pockets"]
    grid = read(os.path.join(target, "pockets.vtu"), vtkXMLUnstructuredGridReader(), faults)
    kinds = check_cells(grid, pockets, records, faults)
    for number, pocket in enumerate(pockets):
        name = f"pocket_{number}.ply"
        check_surface(read(os.path.join(target, name), vtkPLYReader(), faults), pocket, faults, name)
    return len(pockets), sum(len(pocket["maxima"]) > 1 for pocket in pockets), kinds


def main():
    faults, pockets, merged, kinds = Faults(), 0, 0, Counter()
    for name, points, persistence in CASES:
        before = len(faults.found)
        with tempfile.TemporaryDirectory() as folder:
            several = check_case(sys.argv[1], folder, points, persistence, faults)
        pockets, merged, kinds = pockets + several[0], merged + several[1], kinds + several[2]
        faults.found[before:] = [f"{name}: {fault}" for fault in faults.found[before:]]
    faults.expect(pockets > 40 and merged > 3 and kinds, "too few pockets")
    for fault in faults.found[:20]:
        print(fault)
    print(f"{len(CASES)} inputs, {pockets} pockets, {merged} of several maxima, {faults.checks} checks, "
          f"{len(faults.found)} faults")
    return 1 if faults.found else 0


if __name__ == "__main__":
    sys.exit(main())
